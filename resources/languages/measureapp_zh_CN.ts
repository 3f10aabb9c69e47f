<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
  <context>
    <name>actions</name>
    <message>
      <source>Command</source>
      <translation>命令</translation>
    </message>
    <message>
      <source>Commands</source>
      <translation>命令</translation>
    </message>
    <message>
      <source>Everywhere</source>
      <translation>所有页面</translation>
    </message>
    <message>
      <source>It cannot be used at the moment.</source>
      <translation>目前无法使用。</translation>
    </message>
    <message>
      <source>Keys</source>
      <translation>按键</translation>
    </message>
    <message>
      <source>Nothing fits. Try other words.</source>
      <translation>没有匹配项，请换个词。</translation>
    </message>
    <message>
      <source>Search for a command</source>
      <translation>搜索命令</translation>
    </message>
    <message>
      <source>Shortcuts</source>
      <translation>快捷键</translation>
    </message>
    <message>
      <source>This needs the engineer's role.</source>
      <translation>此操作需要工程师角色。</translation>
    </message>
    <message>
      <source>Type what you want to do</source>
      <translation>输入要执行的操作</translation>
    </message>
    <message>
      <source>Where</source>
      <translation>适用页面</translation>
    </message>
    <message>
      <source>small</source>
      <translation>small</translation>
    </message>
    <message>
      <source>title</source>
      <translation>title</translation>
    </message>
  </context>
  <context>
    <name>app</name>
    <message>
      <source>The last action</source>
      <translation>上一步操作</translation>
    </message>
  </context>
  <context>
    <name>charts</name>
    <message>
      <source>Grey levels</source>
      <translation>灰度</translation>
    </message>
    <message>
      <source>Part</source>
      <translation>工件</translation>
    </message>
    <message>
      <source>Points</source>
      <translation>点</translation>
    </message>
    <message>
      <source>Run chart: values in order of measurement, with limits and mean; moving ranges below</source>
      <translation>运行图：按测量顺序的值，带限值和平均值；下方为移动极差</translation>
    </message>
    <message>
      <source>Saturated {saturated}</source>
      <translation>饱和 {saturated}</translation>
    </message>
    <message>
      <source>{counted} points, {ends}</source>
      <translation>{counted} 个点，{ends}</translation>
    </message>
    <message>
      <source>{name}: {count} values, mean {mean}, {beyond} beyond the limits</source>
      <translation>{name}：{count} 个值，均值 {mean}，{beyond} 个超出界限</translation>
    </message>
  </context>
  <context>
    <name>clouds</name>
    <message>
      <source>, at least {least:g}</source>
      <translation>，至少 {least:g}</translation>
    </message>
    <message>
      <source>, at most {most:g}</source>
      <translation>，最多 {most:g}</translation>
    </message>
    <message>
      <source>, filtered {counted}</source>
      <translation>，已过滤 {counted}</translation>
    </message>
    <message>
      <source>, saturated</source>
      <translation>，饱和</translation>
    </message>
    <message>
      <source>Accepted by cloud quality and registration.</source>
      <translation>点云质量与配准均已接受。</translation>
    </message>
    <message>
      <source>Accepted by cloud quality.</source>
      <translation>点云质量已接受。</translation>
    </message>
    <message>
      <source>Analysis failed</source>
      <translation>分析失败</translation>
    </message>
    <message>
      <source>Brightness in the images</source>
      <translation>图像亮度</translation>
    </message>
    <message>
      <source>CSV (*.csv)</source>
      <translation>CSV (*.csv)</translation>
    </message>
    <message>
      <source>Camera</source>
      <translation>相机</translation>
    </message>
    <message>
      <source>Camera {camera}</source>
      <translation>相机 {camera}</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>取消</translation>
    </message>
    <message>
      <source>Cancelled</source>
      <translation>已取消</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was changed; decode to continue.</source>
      <translation>已取消。未作任何更改；解码后继续。</translation>
    </message>
    <message>
      <source>Click a pixel in the picture, or a reason in the list, for an explanation.</source>
      <translation>单击图像中的像素或列表中的原因，即可得到说明。</translation>
    </message>
    <message>
      <source>Cloud</source>
      <translation>点云</translation>
    </message>
    <message>
      <source>Clouds after registration to their neighbours</source>
      <translation>与相邻点云配准后的点云</translation>
    </message>
    <message>
      <source>Clouds placed by robot, guide and table</source>
      <translation>按机器人、导轨和转台放置的点云</translation>
    </message>
    <message>
      <source>Clouds shown</source>
      <translation>显示的点云</translation>
    </message>
    <message>
      <source>Colour</source>
      <translation>颜色</translation>
    </message>
    <message>
      <source>Colour by</source>
      <translation>着色依据</translation>
    </message>
    <message>
      <source>Completeness</source>
      <translation>完整性</translation>
    </message>
    <message>
      <source>Composite</source>
      <translation>合成</translation>
    </message>
    <message>
      <source>Correction</source>
      <translation>修正量</translation>
    </message>
    <message>
      <source>Correction, rotation</source>
      <translation>旋转修正量</translation>
    </message>
    <message>
      <source>Crop and clean the merged cloud; the stitched cloud is kept</source>
      <translation>裁剪并清理合并点云；拼接点云保留</translation>
    </message>
    <message>
      <source>Decode</source>
      <translation>解码</translation>
    </message>
    <message>
      <source>Decoded</source>
      <translation>已解码</translation>
    </message>
    <message>
      <source>Decoded, brightest</source>
      <translation>按最亮曝光解码</translation>
    </message>
    <message>
      <source>Density</source>
      <translation>密度</translation>
    </message>
    <message>
      <source>Determined by kinematics only</source>
      <translation>仅由运动学确定</translation>
    </message>
    <message>
      <source>Distance from the merged surface, in mm</source>
      <translation>到合并表面的距离，mm</translation>
    </message>
    <message>
      <source>Doubtful</source>
      <translation>可疑</translation>
    </message>
    <message>
      <source>Each viewpoint gives a point cloud; registration aligns them. The demo creates some in one or two minutes.</source>
      <translation>每个视点产生一片点云，配准使其对齐。演示在一两分钟内生成若干点云。</translation>
    </message>
    <message>
      <source>Exclude surroundings</source>
      <translation>去除周围物体</translation>
    </message>
    <message>
      <source>Exclude this view</source>
      <translation>排除此视图</translation>
    </message>
    <message>
      <source>Excluded</source>
      <translation>已排除</translation>
    </message>
    <message>
      <source>Excluded manually.</source>
      <translation>手动排除。</translation>
    </message>
    <message>
      <source>Filter</source>
      <translation>过滤</translation>
    </message>
    <message>
      <source>Filtered</source>
      <translation>已过滤</translation>
    </message>
    <message>
      <source>Fit the image into the window</source>
      <translation>使图像适合窗口</translation>
    </message>
    <message>
      <source>Grey</source>
      <translation>灰度</translation>
    </message>
    <message>
      <source>Grey level at {words}: {grey}{full}</source>
      <translation>{words} 处的灰度：{grey}{full}</translation>
    </message>
    <message>
      <source>Grey level, {words}</source>
      <translation>灰度，{words}</translation>
    </message>
    <message>
      <source>Grey levels of the image</source>
      <translation>图像的灰度</translation>
    </message>
    <message>
      <source>Images and holes</source>
      <translation>图像与空洞</translation>
    </message>
    <message>
      <source>Images and holes – {viewpoint_id}</source>
      <translation>图像与空洞 – {viewpoint_id}</translation>
    </message>
    <message>
      <source>Images and holes: {viewpoint_id}</source>
      <translation>图像与空洞：{viewpoint_id}</translation>
    </message>
    <message>
      <source>Images – {viewpoint_id}</source>
      <translation>图像 – {viewpoint_id}</translation>
    </message>
    <message>
      <source>Images: {viewpoint_id}</source>
      <translation>图像：{viewpoint_id}</translation>
    </message>
    <message>
      <source>Images…</source>
      <translation>图像…</translation>
    </message>
    <message>
      <source>Keep surroundings</source>
      <translation>保留周围物体</translation>
    </message>
    <message>
      <source>Kinematic</source>
      <translation>运动学</translation>
    </message>
    <message>
      <source>Limit of the correction</source>
      <translation>修正量限值</translation>
    </message>
    <message>
      <source>Longest unsaturated exposure</source>
      <translation>最长未饱和曝光</translation>
    </message>
    <message>
      <source>Lost in decoding</source>
      <translation>解码时丢失</translation>
    </message>
    <message>
      <source>Lost in matching</source>
      <translation>匹配时丢失</translation>
    </message>
    <message>
      <source>Manual</source>
      <translation>手动</translation>
    </message>
    <message>
      <source>Merged</source>
      <translation>已合并</translation>
    </message>
    <message>
      <source>Merged cloud after filtering</source>
      <translation>过滤后的合并点云</translation>
    </message>
    <message>
      <source>Modulation over noise</source>
      <translation>调制度与噪声之比</translation>
    </message>
    <message>
      <source>Move the mouse over the image, or the arrow keys, to read values.</source>
      <translation>在图像上移动鼠标，或用方向键读取数值。</translation>
    </message>
    <message>
      <source>No</source>
      <translation>否</translation>
    </message>
    <message>
      <source>No clouds yet</source>
      <translation>尚无点云</translation>
    </message>
    <message>
      <source>No views yet.</source>
      <translation>尚无视图。</translation>
    </message>
    <message>
      <source>No views yet. Each viewpoint is listed here once it has been scanned and processed.</source>
      <translation>尚无视图。每个视点扫描并处理后列在此处。</translation>
    </message>
    <message>
      <source>Noise</source>
      <translation>噪声</translation>
    </message>
    <message>
      <source>Nothing was changed. Recompute to continue.</source>
      <translation>未作任何更改。请重新计算以继续。</translation>
    </message>
    <message>
      <source>One colour per view</source>
      <translation>每个视图一种颜色</translation>
    </message>
    <message>
      <source>Order conflicts</source>
      <translation>级次冲突</translation>
    </message>
    <message>
      <source>Orientation σ</source>
      <translation>姿态 σ</translation>
    </message>
    <message>
      <source>Outliers</source>
      <translation>离群点</translation>
    </message>
    <message>
      <source>Overlap</source>
      <translation>重叠</translation>
    </message>
    <message>
      <source>Phase noise (median)</source>
      <translation>相位噪声（中位数）</translation>
    </message>
    <message>
      <source>Pixels decoded</source>
      <translation>已解码像素</translation>
    </message>
    <message>
      <source>Position σ</source>
      <translation>位置 σ</translation>
    </message>
    <message>
      <source>Reasons</source>
      <translation>原因</translation>
    </message>
    <message>
      <source>Recompute</source>
      <translation>重新计算</translation>
    </message>
    <message>
      <source>Registered</source>
      <translation>已配准</translation>
    </message>
    <message>
      <source>Registration</source>
      <translation>配准</translation>
    </message>
    <message>
      <source>Rejected points</source>
      <translation>剔除的点</translation>
    </message>
    <message>
      <source>Removed by cleaning</source>
      <translation>清理时去除</translation>
    </message>
    <message>
      <source>Residual</source>
      <translation>残差</translation>
    </message>
    <message>
      <source>Row {line}, column {across}</source>
      <translation>第 {line} 行，第 {across} 列</translation>
    </message>
    <message>
      <source>Run the demo</source>
      <translation>运行演示</translation>
    </message>
    <message>
      <source>Saturated pixels are red.</source>
      <translation>饱和像素显示为红色。</translation>
    </message>
    <message>
      <source>Save the profile</source>
      <translation>保存剖面</translation>
    </message>
    <message>
      <source>Saved: {name}</source>
      <translation>已保存：{name}</translation>
    </message>
    <message>
      <source>Share</source>
      <translation>占比</translation>
    </message>
    <message>
      <source>Show all</source>
      <translation>显示全部</translation>
    </message>
    <message>
      <source>Show everything from the front</source>
      <translation>从正面显示全部内容</translation>
    </message>
    <message>
      <source>Show or hide this view</source>
      <translation>显示或隐藏此视图</translation>
    </message>
    <message>
      <source>Signal to noise</source>
      <translation>信噪比</translation>
    </message>
    <message>
      <source>Standard deviation of each point, in mm</source>
      <translation>每个点的标准差，mm</translation>
    </message>
    <message>
      <source>State of the pixels</source>
      <translation>像素状态</translation>
    </message>
    <message>
      <source>Stored images, phase, modulation and σ at this pixel, and profiles</source>
      <translation>该像素的已存图像、相位、调制度和 σ，以及剖面曲线</translation>
    </message>
    <message>
      <source>Stored images, phase, modulation, σ and exposures of the selected view, and profiles</source>
      <translation>所选视图的已存图像、相位、调制度、σ 和曝光，以及剖面</translation>
    </message>
    <message>
      <source>The first cloud appears when the first viewpoint is processed.</source>
      <translation>处理第一个视点后显示第一片点云。</translation>
    </message>
    <message>
      <source>The images are decoded; the project is not changed.</source>
      <translation>图像已解码；项目未更改。</translation>
    </message>
    <message>
      <source>The images of the selected view, and why pixels have no point</source>
      <translation>所选视图的图像，以及像素没有点的原因</translation>
    </message>
    <message>
      <source>The pixels can be inspected as soon as this is complete.</source>
      <translation>完成后即可检查像素。</translation>
    </message>
    <message>
      <source>The profile was not saved: {error}</source>
      <translation>剖面未保存：{error}</translation>
    </message>
    <message>
      <source>The space bar shows or hides the selected view.</source>
      <translation>空格键显示或隐藏所选视图。</translation>
    </message>
    <message>
      <source>The view is recomputed from its stored images.</source>
      <translation>视图由其已存图像重新计算。</translation>
    </message>
    <message>
      <source>This view has not been analysed yet.</source>
      <translation>此视图尚未分析。</translation>
    </message>
    <message>
      <source>Tracing the point</source>
      <translation>正在追踪该点</translation>
    </message>
    <message>
      <source>Undo</source>
      <translation>撤销</translation>
    </message>
    <message>
      <source>Undo the last change of the colour scale</source>
      <translation>撤销上一次色标更改</translation>
    </message>
    <message>
      <source>Undo the last choice of a view</source>
      <translation>撤销上一次视图选择</translation>
    </message>
    <message>
      <source>Undo the last filter</source>
      <translation>撤销上一次过滤</translation>
    </message>
    <message>
      <source>Undo the last measured point or distance</source>
      <translation>撤销上一个测量点或距离</translation>
    </message>
    <message>
      <source>Use this view anyway</source>
      <translation>仍使用此视图</translation>
    </message>
    <message>
      <source>Used</source>
      <translation>已使用</translation>
    </message>
    <message>
      <source>Used by manual choice. {why}</source>
      <translation>因手动选择而使用。{why}</translation>
    </message>
    <message>
      <source>Valid pixels</source>
      <translation>有效像素</translation>
    </message>
    <message>
      <source>Values along a line, which the mouse or the numbers move</source>
      <translation>沿直线的数值，直线由鼠标或数字移动</translation>
    </message>
    <message>
      <source>Values…</source>
      <translation>数值…</translation>
    </message>
    <message>
      <source>Views</source>
      <translation>视图</translation>
    </message>
    <message>
      <source>Weighted mean of all registered clouds</source>
      <translation>所有已配准点云的加权平均</translation>
    </message>
    <message>
      <source>Yes</source>
      <translation>是</translation>
    </message>
    <message>
      <source>accepted by hand</source>
      <translation>手动接受</translation>
    </message>
    <message>
      <source>grey level</source>
      <translation>灰度</translation>
    </message>
    <message>
      <source>per mm²</source>
      <translation>每 mm²</translation>
    </message>
    <message>
      <source>phase noise</source>
      <translation>相位噪声</translation>
    </message>
    <message>
      <source>point σ</source>
      <translation>点 σ</translation>
    </message>
    <message>
      <source>projector column</source>
      <translation>投影仪列</translation>
    </message>
    <message>
      <source>refused by hand</source>
      <translation>手动拒绝</translation>
    </message>
    <message>
      <source>view</source>
      <translation>个视图</translation>
    </message>
    <message>
      <source>views</source>
      <translation>个视图</translation>
    </message>
    <message>
      <source>{counted} points. Pixels with measured surface: {said}.</source>
      <translation>{counted} 个点。有测量表面的像素：{said}。</translation>
    </message>
    <message>
      <source>{count}, {total} points</source>
      <translation>{count}，{total} 个点</translation>
    </message>
    <message>
      <source>{quantity} decoded from all unsaturated exposures, {quantity_2} from the brightest unsaturated one alone (rule of the paper).</source>
      <translation>由全部未饱和曝光解码 {quantity}，仅由最亮的未饱和曝光解码 {quantity_2}（论文规则）。</translation>
    </message>
    <message>
      <source>{view}   sigma {sigma}</source>
      <translation>{view}   sigma {sigma}</translation>
    </message>
    <message>
      <source>{words}, kinematic positions.</source>
      <translation>{words}，运动学位置。</translation>
    </message>
    <message>
      <source>{words}; merged {counted}</source>
      <translation>{words}；合并后 {counted}</translation>
    </message>
  </context>
  <context>
    <name>controllers</name>
    <message>
      <source> It is stored in the project.</source>
      <translation>它已保存在项目中。</translation>
    </message>
    <message>
      <source>, blur {blur_px}</source>
      <translation>，模糊 {blur_px}</translation>
    </message>
    <message>
      <source>3-D report (HTML)</source>
      <translation>三维报告 (HTML)</translation>
    </message>
    <message>
      <source>Add {id}</source>
      <translation>添加 {id}</translation>
    </message>
    <message>
      <source>Adding to the series</source>
      <translation>正在加入系列</translation>
    </message>
    <message>
      <source>All devices are connected and ready.</source>
      <translation>所有设备已连接并就绪。</translation>
    </message>
    <message>
      <source>All images are taken.</source>
      <translation>所有图像已采集。</translation>
    </message>
    <message>
      <source>Allowing the driver</source>
      <translation>正在允许驱动</translation>
    </message>
    <message>
      <source>Analysing {viewpoint_id}</source>
      <translation>正在分析 {viewpoint_id}</translation>
    </message>
    <message>
      <source>Another task is running: {busy_with}. Save the rig when it has ended.</source>
      <translation>另一任务正在运行：{busy_with}。请在其结束后保存测量系统。</translation>
    </message>
    <message>
      <source>Another: {words}</source>
      <translation>其他：{words}</translation>
    </message>
    <message>
      <source>Being measured again</source>
      <translation>正在重新测量</translation>
    </message>
    <message>
      <source>Calibrate again.</source>
      <translation>请重新标定。</translation>
    </message>
    <message>
      <source>Calibrate the rig, then press Recompute on the page Scan.</source>
      <translation>请标定测量系统，然后在“扫描”页按“重新计算”。</translation>
    </message>
    <message>
      <source>Calibration of the rig</source>
      <translation>测量系统标定</translation>
    </message>
    <message>
      <source>Call the engineer.</source>
      <translation>请呼叫工程师。</translation>
    </message>
    <message>
      <source>Camera {name}</source>
      <translation>相机 {name}</translation>
    </message>
    <message>
      <source>Cancelled.</source>
      <translation>已取消。</translation>
    </message>
    <message>
      <source>Changing the nominal</source>
      <translation>正在更改名义模型</translation>
    </message>
    <message>
      <source>Check the values, then choose Create.</source>
      <translation>请核对数值，然后选择“创建”。</translation>
    </message>
    <message>
      <source>Checking before the start</source>
      <translation>正在进行启动前检查</translation>
    </message>
    <message>
      <source>Checking the PIN</source>
      <translation>正在检查 PIN</translation>
    </message>
    <message>
      <source>Checking the plan</source>
      <translation>正在检查计划</translation>
    </message>
    <message>
      <source>Checking the scan</source>
      <translation>正在检查扫描</translation>
    </message>
    <message>
      <source>Checking with views held back</source>
      <translation>正在用保留的视图检验</translation>
    </message>
    <message>
      <source>Choice undone. Views stitched again.</source>
      <translation>选择已撤销。视图已重新拼接。</translation>
    </message>
    <message>
      <source>Choose a new folder, or the folder of a project.</source>
      <translation>请选择新文件夹或项目文件夹。</translation>
    </message>
    <message>
      <source>Choose a rig on the page Rig first.</source>
      <translation>请先在“测量系统”页选择测量系统。</translation>
    </message>
    <message>
      <source>Choose files of the same part, or other units.</source>
      <translation>请选择同一工件的文件，或其他单位。</translation>
    </message>
    <message>
      <source>Choose one by Nominal…, or click Feature above the picture and grow a shape from a measured point.</source>
      <translation>请通过“名义模型…”选择一个，或单击图像上方的“特征”，从测量点生长出形状。</translation>
    </message>
    <message>
      <source>Choose one on the page Rig.</source>
      <translation>请在“测量系统”页选择一个。</translation>
    </message>
    <message>
      <source>Choose the nominal of the part to see the predicted coverage.</source>
      <translation>选择工件的名义模型以查看预计覆盖率。</translation>
    </message>
    <message>
      <source>Choose the nominal of this part, or export it in millimetres.</source>
      <translation>请选择此工件的名义模型，或以毫米导出。</translation>
    </message>
    <message>
      <source>Click another point, or choose another shape.</source>
      <translation>请单击另一点，或选择另一形状。</translation>
    </message>
    <message>
      <source>Click its wall at the other end.</source>
      <translation>单击另一端的槽壁。</translation>
    </message>
    <message>
      <source>Click one face of the edge, beside it.</source>
      <translation>单击棱边旁的一个面。</translation>
    </message>
    <message>
      <source>Click one of the holes, or the face beside it; all equal ones are found.</source>
      <translation>单击其中一个孔或其旁边的面；将找出所有相同的孔。</translation>
    </message>
    <message>
      <source>Click the edge.</source>
      <translation>单击棱边。</translation>
    </message>
    <message>
      <source>Click the other face of the edge.</source>
      <translation>单击棱边的另一个面。</translation>
    </message>
    <message>
      <source>Click the second place, on the same wall.</source>
      <translation>单击同一壁面上的第二处。</translation>
    </message>
    <message>
      <source>Click the third place, on the same wall.</source>
      <translation>单击同一壁面上的第三处。</translation>
    </message>
    <message>
      <source>Click the wall of one straight side.</source>
      <translation>单击一条直边的槽壁。</translation>
    </message>
    <message>
      <source>Click the wall of the hole or pin, or the face beside it.</source>
      <translation>单击孔或销的壁面，或其旁边的面。</translation>
    </message>
    <message>
      <source>Click the wall of the hole or pin: the first of three places around it.</source>
      <translation>单击孔或销的壁面：绕一周三处中的第一处。</translation>
    </message>
    <message>
      <source>Click the wall of the other side.</source>
      <translation>单击另一条直边的槽壁。</translation>
    </message>
    <message>
      <source>Click the wall of the slot at one of its round ends.</source>
      <translation>单击槽一个圆端处的槽壁。</translation>
    </message>
    <message>
      <source>Click the wall of the slot, or the face beside it.</source>
      <translation>单击槽的壁面，或其旁边的面。</translation>
    </message>
    <message>
      <source>Click where the line begins.</source>
      <translation>单击直线的起点。</translation>
    </message>
    <message>
      <source>Click where the line ends, on the same face.</source>
      <translation>在同一面上单击直线的终点。</translation>
    </message>
    <message>
      <source>Comparing the measurements</source>
      <translation>正在比较测量结果</translation>
    </message>
    <message>
      <source>Comparing the scan with its nominal</source>
      <translation>正在将扫描与名义模型比较</translation>
    </message>
    <message>
      <source>Comparing with the nominal</source>
      <translation>正在与名义模型比较</translation>
    </message>
    <message>
      <source>Connect its disk again, or put the folder back where it was.</source>
      <translation>请重新连接其磁盘，或把该文件夹放回原处。</translation>
    </message>
    <message>
      <source>Connect the rig on the page Rig first.</source>
      <translation>请先在“测量系统”页连接测量系统。</translation>
    </message>
    <message>
      <source>Connected, but not ready: {list}.</source>
      <translation>已连接，但未就绪：{list}。</translation>
    </message>
    <message>
      <source>Connecting the devices</source>
      <translation>正在连接设备</translation>
    </message>
    <message>
      <source>Connecting the rig</source>
      <translation>正在连接测量系统</translation>
    </message>
    <message>
      <source>Connecting {name}</source>
      <translation>正在连接 {name}</translation>
    </message>
    <message>
      <source>Copying the project</source>
      <translation>正在复制项目</translation>
    </message>
    <message>
      <source>Could not be measured</source>
      <translation>无法测量</translation>
    </message>
    <message>
      <source>Coverage is predicted for up to {most_viewpoints} viewpoints.</source>
      <translation>最多预测 {most_viewpoints} 个视点的覆盖率。</translation>
    </message>
    <message>
      <source>Ctrl+Y makes the change again.</source>
      <translation>按 Ctrl+Y 可重做此更改。</translation>
    </message>
    <message>
      <source>Current</source>
      <translation>当前</translation>
    </message>
    <message>
      <source>Data stored so far is kept.</source>
      <translation>已存储的数据会保留。</translation>
    </message>
    <message>
      <source>Decoding {viewpoint_id}</source>
      <translation>正在解码 {viewpoint_id}</translation>
    </message>
    <message>
      <source>Demo: {stem}</source>
      <translation>演示：{stem}</translation>
    </message>
    <message>
      <source>Detecting the board in {name}</source>
      <translation>正在 {name} 中检测标定板</translation>
    </message>
    <message>
      <source>Dimensions (CSV)</source>
      <translation>尺寸表 (CSV)</translation>
    </message>
    <message>
      <source>Dimensions (XLSX)</source>
      <translation>尺寸表 (XLSX)</translation>
    </message>
    <message>
      <source>Dimensions still refer to the stitched cloud.</source>
      <translation>尺寸仍以拼接点云为准。</translation>
    </message>
    <message>
      <source>Disconnecting</source>
      <translation>正在断开</translation>
    </message>
    <message>
      <source>Disconnecting the rig</source>
      <translation>正在断开测量系统</translation>
    </message>
    <message>
      <source>Distortion</source>
      <translation>畸变</translation>
    </message>
    <message>
      <source>Documents</source>
      <translation>文档</translation>
    </message>
    <message>
      <source>Drawing</source>
      <translation>图纸</translation>
    </message>
    <message>
      <source>Duplicate</source>
      <translation>复制</translation>
    </message>
    <message>
      <source>Evaluating the result</source>
      <translation>正在评定结果</translation>
    </message>
    <message>
      <source>Everything as JSON</source>
      <translation>全部内容 (JSON)</translation>
    </message>
    <message>
      <source>Everything was stopped.</source>
      <translation>已全部停止。</translation>
    </message>
    <message>
      <source>Exporting {name}</source>
      <translation>正在导出 {name}</translation>
    </message>
    <message>
      <source>Exposures</source>
      <translation>曝光</translation>
    </message>
    <message>
      <source>Extending the plan</source>
      <translation>正在扩展计划</translation>
    </message>
    <message>
      <source>Filing the result</source>
      <translation>正在归档结果</translation>
    </message>
    <message>
      <source>Filtering</source>
      <translation>正在过滤</translation>
    </message>
    <message>
      <source>Finding the face</source>
      <translation>正在查找面</translation>
    </message>
    <message>
      <source>Finding the feature</source>
      <translation>正在查找特征</translation>
    </message>
    <message>
      <source>Finding the references</source>
      <translation>正在查找参考点</translation>
    </message>
    <message>
      <source>Generate</source>
      <translation>生成</translation>
    </message>
    <message>
      <source>Generating a plan</source>
      <translation>正在生成计划</translation>
    </message>
    <message>
      <source>Go on with the page Scan.</source>
      <translation>请在“扫描”页继续。</translation>
    </message>
    <message>
      <source>Growing a feature</source>
      <translation>正在生长特征</translation>
    </message>
    <message>
      <source>Guide and table find their references</source>
      <translation>导轨和转台回参考点</translation>
    </message>
    <message>
      <source>Inspection program changed.</source>
      <translation>检测程序已更改。</translation>
    </message>
    <message>
      <source>It is one of {own}; the rig has {rig}.</source>
      <translation>它是 {own} 的；此测量系统有 {rig}。</translation>
    </message>
    <message>
      <source>Its images are stored.</source>
      <translation>其图像已保存。</translation>
    </message>
    <message>
      <source>Largest residual</source>
      <translation>最大残差</translation>
    </message>
    <message>
      <source>Last filter undone.</source>
      <translation>已撤销上一次过滤。</translation>
    </message>
    <message>
      <source>Live images</source>
      <translation>实时图像</translation>
    </message>
    <message>
      <source>Loading the drivers</source>
      <translation>正在加载驱动</translation>
    </message>
    <message>
      <source>Loading the rig</source>
      <translation>正在加载测量系统</translation>
    </message>
    <message>
      <source>Looking for what is stored</source>
      <translation>正在查看已存储的内容</translation>
    </message>
    <message>
      <source>Made again: {words}</source>
      <translation>已重做：{words}</translation>
    </message>
    <message>
      <source>Make one on the page Plan, or choose a plan file.</source>
      <translation>请在“计划”页制定一个，或选择计划文件。</translation>
    </message>
    <message>
      <source>Making the project</source>
      <translation>正在创建项目</translation>
    </message>
    <message>
      <source>Measurement</source>
      <translation>测量</translation>
    </message>
    <message>
      <source>Measuring again</source>
      <translation>正在重新测量</translation>
    </message>
    <message>
      <source>Measuring {name}</source>
      <translation>正在测量 {name}</translation>
    </message>
    <message>
      <source>Moving by hand</source>
      <translation>手动移动中</translation>
    </message>
    <message>
      <source>New project</source>
      <translation>新建项目</translation>
    </message>
    <message>
      <source>New projects start from it: New project from a template.</source>
      <translation>新项目以此为基础：从模板新建项目。</translation>
    </message>
    <message>
      <source>No PDF viewer is installed.</source>
      <translation>未安装 PDF 阅读器。</translation>
    </message>
    <message>
      <source>No PIN is set: anyone can leave operator mode.</source>
      <translation>未设置 PIN：任何人都可离开操作模式。</translation>
    </message>
    <message>
      <source>No image shows the board</source>
      <translation>没有图像拍到标定板</translation>
    </message>
    <message>
      <source>No program is at hand, or a job is running.</source>
      <translation>没有可用的程序，或有任务正在运行。</translation>
    </message>
    <message>
      <source>No project folder is chosen.</source>
      <translation>未选择项目文件夹。</translation>
    </message>
    <message>
      <source>No project is open.</source>
      <translation>没有打开的项目。</translation>
    </message>
    <message>
      <source>No rig is chosen.</source>
      <translation>未选择测量系统。</translation>
    </message>
    <message>
      <source>No rig is known yet.</source>
      <translation>尚无已知的测量系统。</translation>
    </message>
    <message>
      <source>No surface: {reason}</source>
      <translation>没有表面：{reason}</translation>
    </message>
    <message>
      <source>No view of the board shows the fringes</source>
      <translation>没有标定板视图显示条纹</translation>
    </message>
    <message>
      <source>No {shape} found there: {reason}.</source>
      <translation>那里未找到{shape}：{reason}。</translation>
    </message>
    <message>
      <source>Noise of a corner (1 σ)</source>
      <translation>角点噪声（1 σ）</translation>
    </message>
    <message>
      <source>Noise of a mark (1 σ)</source>
      <translation>标记点噪声（1 σ）</translation>
    </message>
    <message>
      <source>Nominal changed back.</source>
      <translation>名义模型已改回。</translation>
    </message>
    <message>
      <source>Nominal changed to {name}.</source>
      <translation>名义模型已改为 {name}。</translation>
    </message>
    <message>
      <source>Nothing can be scanned or recomputed here until that has ended. Then open the project again.</source>
      <translation>在其结束之前无法在此扫描或重新计算。之后请重新打开项目。</translation>
    </message>
    <message>
      <source>Open a calibrated project with a plan, or scan the part first.</source>
      <translation>请打开带计划的已标定项目，或先扫描工件。</translation>
    </message>
    <message>
      <source>Open a project or run the demo first.</source>
      <translation>请先打开项目或运行演示。</translation>
    </message>
    <message>
      <source>Open patch (STL)</source>
      <translation>开放面片 (STL)</translation>
    </message>
    <message>
      <source>Open the project's plan</source>
      <translation>打开项目的计划</translation>
    </message>
    <message>
      <source>Open {name}</source>
      <translation>打开 {name}</translation>
    </message>
    <message>
      <source>Opening project</source>
      <translation>正在打开项目</translation>
    </message>
    <message>
      <source>Opening the calibration</source>
      <translation>正在打开标定</translation>
    </message>
    <message>
      <source>Opening the sample project</source>
      <translation>正在打开示例项目</translation>
    </message>
    <message>
      <source>Opening the session</source>
      <translation>正在打开会话</translation>
    </message>
    <message>
      <source>Opening {name}</source>
      <translation>正在打开 {name}</translation>
    </message>
    <message>
      <source>Operator mode again: there was no input for a while.</source>
      <translation>已回到操作模式：一段时间没有输入。</translation>
    </message>
    <message>
      <source>Order of the viewpoints</source>
      <translation>视点顺序</translation>
    </message>
    <message>
      <source>Ordering the viewpoints</source>
      <translation>正在排列视点</translation>
    </message>
    <message>
      <source>PDF report</source>
      <translation>PDF 报告</translation>
    </message>
    <message>
      <source>Preparing the 3-D view</source>
      <translation>正在准备三维视图</translation>
    </message>
    <message>
      <source>Preparing the measurement</source>
      <translation>正在准备测量</translation>
    </message>
    <message>
      <source>Preparing the measurement: </source>
      <translation>正在准备测量：</translation>
    </message>
    <message>
      <source>Preparing the scan</source>
      <translation>正在准备扫描</translation>
    </message>
    <message>
      <source>Press Recompute on the page Scan; no new scan is needed.</source>
      <translation>请在“扫描”页按“重新计算”；无需重新扫描。</translation>
    </message>
    <message>
      <source>Program and results saved.</source>
      <translation>程序和结果已保存。</translation>
    </message>
    <message>
      <source>Program saved as {name}.</source>
      <translation>程序已保存为 {name}。</translation>
    </message>
    <message>
      <source>Program saved.</source>
      <translation>程序已保存。</translation>
    </message>
    <message>
      <source>Reading clouds</source>
      <translation>正在读取点云</translation>
    </message>
    <message>
      <source>Reading images</source>
      <translation>正在读取图像</translation>
    </message>
    <message>
      <source>Reading the devices</source>
      <translation>正在读取设备</translation>
    </message>
    <message>
      <source>Reading the driver</source>
      <translation>正在读取驱动</translation>
    </message>
    <message>
      <source>Reading the files</source>
      <translation>正在读取文件</translation>
    </message>
    <message>
      <source>Reading the images of {viewpoint_id}</source>
      <translation>正在读取 {viewpoint_id} 的图像</translation>
    </message>
    <message>
      <source>Reading the measurements</source>
      <translation>正在读取测量结果</translation>
    </message>
    <message>
      <source>Reading the mesh</source>
      <translation>正在读取网格</translation>
    </message>
    <message>
      <source>Reading the part programs</source>
      <translation>正在读取工件程序</translation>
    </message>
    <message>
      <source>Reading the program</source>
      <translation>正在读取程序</translation>
    </message>
    <message>
      <source>Reading the project</source>
      <translation>正在读取项目</translation>
    </message>
    <message>
      <source>Reading the report header</source>
      <translation>正在读取报告抬头</translation>
    </message>
    <message>
      <source>Reading the series</source>
      <translation>正在读取系列</translation>
    </message>
    <message>
      <source>Reading view {id}</source>
      <translation>正在读取视图 {id}</translation>
    </message>
    <message>
      <source>Reading {name}</source>
      <translation>正在读取 {name}</translation>
    </message>
    <message>
      <source>Ready.</source>
      <translation>就绪。</translation>
    </message>
    <message>
      <source>Recompute the project to create one.</source>
      <translation>请重新计算项目以生成。</translation>
    </message>
    <message>
      <source>Recomputing</source>
      <translation>正在重新计算</translation>
    </message>
    <message>
      <source>Releasing the part programs</source>
      <translation>正在发布工件程序</translation>
    </message>
    <message>
      <source>Rendering the pages</source>
      <translation>正在渲染页面</translation>
    </message>
    <message>
      <source>Rendering the report</source>
      <translation>正在渲染报告</translation>
    </message>
    <message>
      <source>Repeat {number} of {count}</source>
      <translation>第 {number} 次重复，共 {count} 次</translation>
    </message>
    <message>
      <source>Report header</source>
      <translation>报告抬头</translation>
    </message>
    <message>
      <source>Reprojection (rms)</source>
      <translation>重投影（均方根）</translation>
    </message>
    <message>
      <source>Reset the stop on the Rig page before anything moves again.</source>
      <translation>在任何运动之前，请在“测量系统”页复位停止。</translation>
    </message>
    <message>
      <source>Retake it if you need it after all.</source>
      <translation>若仍需要，请重拍。</translation>
    </message>
    <message>
      <source>Run `python3 installer/bootstrap.py run` to repair the installation.</source>
      <translation>运行 `python3 installer/bootstrap.py run` 修复安装。</translation>
    </message>
    <message>
      <source>Run the demo, or open a project.</source>
      <translation>请运行演示，或打开项目。</translation>
    </message>
    <message>
      <source>Run the demo, or recompute the project.</source>
      <translation>请运行演示，或重新计算项目。</translation>
    </message>
    <message>
      <source>Saved to {words}.</source>
      <translation>已保存到 {words}。</translation>
    </message>
    <message>
      <source>Saving the program</source>
      <translation>正在保存程序</translation>
    </message>
    <message>
      <source>Saving the report header</source>
      <translation>正在保存报告抬头</translation>
    </message>
    <message>
      <source>Saving the rig</source>
      <translation>正在保存测量系统</translation>
    </message>
    <message>
      <source>Saving the template</source>
      <translation>正在保存模板</translation>
    </message>
    <message>
      <source>Saving {name}</source>
      <translation>正在保存 {name}</translation>
    </message>
    <message>
      <source>Scan</source>
      <translation>扫描</translation>
    </message>
    <message>
      <source>See the list on the page Scan.</source>
      <translation>请查看“扫描”页的列表。</translation>
    </message>
    <message>
      <source>See the remedy in the table of devices.</source>
      <translation>请参见设备表中的补救措施。</translation>
    </message>
    <message>
      <source>Set one by the button beside the role.</source>
      <translation>请用角色旁的按钮设置。</translation>
    </message>
    <message>
      <source>Solving</source>
      <translation>正在求解</translation>
    </message>
    <message>
      <source>Stale: the program has changed since this was measured</source>
      <translation>过期：测量之后程序已更改</translation>
    </message>
    <message>
      <source>Stitched cloud (PLY)</source>
      <translation>拼接点云 (PLY)</translation>
    </message>
    <message>
      <source>Stitching again</source>
      <translation>正在重新拼接</translation>
    </message>
    <message>
      <source>Stop was pressed.</source>
      <translation>已按下停止。</translation>
    </message>
    <message>
      <source>Stopped.</source>
      <translation>已停止。</translation>
    </message>
    <message>
      <source>Storing</source>
      <translation>正在保存</translation>
    </message>
    <message>
      <source>Storing raw images as the project states</source>
      <translation>正在按项目规定保存原始图像</translation>
    </message>
    <message>
      <source>Storing the PIN</source>
      <translation>正在保存 PIN</translation>
    </message>
    <message>
      <source>Storing the plan</source>
      <translation>正在保存计划</translation>
    </message>
    <message>
      <source>Storing the settings</source>
      <translation>正在保存设置</translation>
    </message>
    <message>
      <source>Surface mesh (STL)</source>
      <translation>表面网格 (STL)</translation>
    </message>
    <message>
      <source>Taking images of the board</source>
      <translation>正在拍摄标定板图像</translation>
    </message>
    <message>
      <source>The 3-D view could not be loaded. Install the graphics libraries listed in the help.</source>
      <translation>无法加载三维视图。请安装帮助中列出的图形库。</translation>
    </message>
    <message>
      <source>The calibration and the disk are being checked.</source>
      <translation>正在检查标定和磁盘。</translation>
    </message>
    <message>
      <source>The calibration is accepted.</source>
      <translation>标定已接受。</translation>
    </message>
    <message>
      <source>The calibration is kept: it would come out as it is.</source>
      <translation>保留标定：重新计算的结果不会改变。</translation>
    </message>
    <message>
      <source>The calibration of the last session is in use again.</source>
      <translation>重新使用上次会话的标定。</translation>
    </message>
    <message>
      <source>The clouds are computed and stitched.</source>
      <translation>点云已计算并拼接。</translation>
    </message>
    <message>
      <source>The code belongs to this part.</source>
      <translation>此条码属于该工件。</translation>
    </message>
    <message>
      <source>The code {shown} belongs to no part program. Choose the part by its card, or call the engineer.</source>
      <translation>代码 {shown} 不属于任何工件程序。请按卡片选择工件，或呼叫工程师。</translation>
    </message>
    <message>
      <source>The code {shown} fits several part programs: {list}. Choose one by its card.</source>
      <translation>代码 {shown} 适合多个工件程序：{list}。请按卡片选择。</translation>
    </message>
    <message>
      <source>The code {shown} is not one of part {value}. Nothing was entered.</source>
      <translation>代码 {shown} 不是工件 {value} 的。未输入任何内容。</translation>
    </message>
    <message>
      <source>The code {shown} was not entered. Press Back to identify another part.</source>
      <translation>未输入条码 {shown}。要测量其他工件，请按“返回”。</translation>
    </message>
    <message>
      <source>The coverage is being predicted…</source>
      <translation>正在预测覆盖率…</translation>
    </message>
    <message>
      <source>The disk has {value:.1f} GB free, and this part needs {value_2:.1f} GB.</source>
      <translation>磁盘可用 {value:.1f} GB，而此工件需要 {value_2:.1f} GB。</translation>
    </message>
    <message>
      <source>The file manager could not be opened.</source>
      <translation>无法打开文件管理器。</translation>
    </message>
    <message>
      <source>The filter removes no points.</source>
      <translation>过滤器未去除任何点。</translation>
    </message>
    <message>
      <source>The images are stored. They are not processed, because the project has no calibration.</source>
      <translation>图像已存储。由于项目没有标定，未作处理。</translation>
    </message>
    <message>
      <source>The images of this view are not on disk. Open the project that contains them.</source>
      <translation>此视图的图像不在磁盘上。请打开包含它们的项目。</translation>
    </message>
    <message>
      <source>The inspection program has edits that are not saved.</source>
      <translation>检测程序有未保存的编辑。</translation>
    </message>
    <message>
      <source>The measurement was stopped.</source>
      <translation>测量已停止。</translation>
    </message>
    <message>
      <source>The next scan uses this plan of {count} viewpoints.{where}</source>
      <translation>下次扫描使用此计划，共 {count} 个视点。{where}</translation>
    </message>
    <message>
      <source>The package {name} is missing.</source>
      <translation>缺少软件包 {name}。</translation>
    </message>
    <message>
      <source>The page Inspect shows the worst dimension first.</source>
      <translation>“检测”页首先显示最差的尺寸。</translation>
    </message>
    <message>
      <source>The part programs in {folder} cannot be read: {value}.</source>
      <translation>无法读取 {folder} 中的工件程序：{value}。</translation>
    </message>
    <message>
      <source>The plan is saved as {name}.</source>
      <translation>计划已保存为 {name}。</translation>
    </message>
    <message>
      <source>The position of the rig is not known.</source>
      <translation>测量系统的位置未知。</translation>
    </message>
    <message>
      <source>The project folder {folder} is gone.</source>
      <translation>项目文件夹 {folder} 已不存在。</translation>
    </message>
    <message>
      <source>The project is saved to {folder}.</source>
      <translation>项目已保存到 {folder}。</translation>
    </message>
    <message>
      <source>The project was recomputed from the stored images.</source>
      <translation>已由存储的图像重新计算项目。</translation>
    </message>
    <message>
      <source>The report is saved to {path}.</source>
      <translation>报告已保存到 {path}。</translation>
    </message>
    <message>
      <source>The report of repeats is saved as {name}, with a table (CSV) and JSON beside it.</source>
      <translation>重复测量报告已保存为 {name}，旁有表格 (CSV) 和 JSON。</translation>
    </message>
    <message>
      <source>The report of the series is saved as {name}, with a table (CSV) and JSON beside it.</source>
      <translation>系列报告已保存为 {name}，旁有表格 (CSV) 和 JSON。</translation>
    </message>
    <message>
      <source>The result is filed; its report could not be copied to {target}: {error}.</source>
      <translation>结果已归档；其报告无法复制到 {target}：{error}。</translation>
    </message>
    <message>
      <source>The result is saved, but the rig keeps its own cameras.</source>
      <translation>结果已保存，但测量系统保留自己的相机。</translation>
    </message>
    <message>
      <source>The rig is being loaded.</source>
      <translation>正在加载测量系统。</translation>
    </message>
    <message>
      <source>The rig is calibrated.</source>
      <translation>测量系统已标定。</translation>
    </message>
    <message>
      <source>The rig is calibrated. {sentence}</source>
      <translation>测量系统已标定。{sentence}</translation>
    </message>
    <message>
      <source>The rig was saved to {path}.</source>
      <translation>测量系统已保存到 {path}。</translation>
    </message>
    <message>
      <source>The rig was stopped: {stopped} {call}</source>
      <translation>测量系统已停止：{stopped} {call}</translation>
    </message>
    <message>
      <source>The scan continues with the next one.</source>
      <translation>扫描继续下一个。</translation>
    </message>
    <message>
      <source>The scan continues.</source>
      <translation>扫描继续。</translation>
    </message>
    <message>
      <source>The scan failed.</source>
      <translation>扫描失败。</translation>
    </message>
    <message>
      <source>The scan pauses before its first viewpoint; what comes before it can only be cancelled.</source>
      <translation>扫描在第一个视点之前暂停；之前的步骤只能取消。</translation>
    </message>
    <message>
      <source>The scan started.</source>
      <translation>扫描已开始。</translation>
    </message>
    <message>
      <source>The stitched cloud is kept: it would come out as it is.</source>
      <translation>保留拼接点云：重新计算的结果不会改变。</translation>
    </message>
    <message>
      <source>The stored results are those of the program before.</source>
      <translation>存储的结果属于之前的程序。</translation>
    </message>
    <message>
      <source>The template is saved to {path}.</source>
      <translation>模板已保存到 {path}。</translation>
    </message>
    <message>
      <source>The views collected so far are kept.</source>
      <translation>已采集的视图会保留。</translation>
    </message>
    <message>
      <source>The {subject} is complete.</source>
      <translation>{subject}已完成。</translation>
    </message>
    <message>
      <source>There is no CAD model whose faces could be picked.</source>
      <translation>没有可供选取面的 CAD 模型。</translation>
    </message>
    <message>
      <source>There is no PDF report yet.</source>
      <translation>尚无 PDF 报告。</translation>
    </message>
    <message>
      <source>There is no measurement to repeat.</source>
      <translation>没有可重复的测量。</translation>
    </message>
    <message>
      <source>There is no measurement yet.</source>
      <translation>尚无测量结果。</translation>
    </message>
    <message>
      <source>There is no scan plan.</source>
      <translation>没有扫描计划。</translation>
    </message>
    <message>
      <source>There is nothing at the clicked place: click the part.</source>
      <translation>单击处没有任何内容：请单击工件。</translation>
    </message>
    <message>
      <source>This is impossible: {problem}</source>
      <translation>无法做到：{problem}</translation>
    </message>
    <message>
      <source>This measurement has no surface mesh.</source>
      <translation>此测量没有表面网格。</translation>
    </message>
    <message>
      <source>This project's: {words}</source>
      <translation>本项目的：{words}</translation>
    </message>
    <message>
      <source>Times of the moves</source>
      <translation>移动时间</translation>
    </message>
    <message>
      <source>Tolerance of {name} changed.</source>
      <translation>{name} 的公差已更改。</translation>
    </message>
    <message>
      <source>Undo (Ctrl+Z) brings it back.</source>
      <translation>按 Ctrl+Z 撤销即可恢复。</translation>
    </message>
    <message>
      <source>Undoing the filter</source>
      <translation>正在撤销过滤</translation>
    </message>
    <message>
      <source>Undone: {words}</source>
      <translation>已撤销：{words}</translation>
    </message>
    <message>
      <source>Unpacking the sample project</source>
      <translation>正在解压示例项目</translation>
    </message>
    <message>
      <source>Up to {most_ordered} can be.</source>
      <translation>最多可以 {most_ordered} 个。</translation>
    </message>
    <message>
      <source>Use stricter limits, or another filter.</source>
      <translation>请使用更严格的限值，或其他过滤器。</translation>
    </message>
    <message>
      <source>Viewpoint {viewpoint_id} failed: {reason}</source>
      <translation>视点 {viewpoint_id} 失败：{reason}</translation>
    </message>
    <message>
      <source>Viewpoint {viewpoint_id} has no cloud: {reason}</source>
      <translation>视点 {viewpoint_id} 没有点云：{reason}</translation>
    </message>
    <message>
      <source>Viewpoint {viewpoint_id} is taken again: {reason}</source>
      <translation>重拍视点 {viewpoint_id}：{reason}</translation>
    </message>
    <message>
      <source>Viewpoint {viewpoint_id} was skipped.</source>
      <translation>已跳过视点 {viewpoint_id}。</translation>
    </message>
    <message>
      <source>Viewpoint {viewpoint_id}: exposures</source>
      <translation>视点 {viewpoint_id}：曝光</translation>
    </message>
    <message>
      <source>Viewpoint {viewpoint_id}: {reason}</source>
      <translation>视点 {viewpoint_id}：{reason}</translation>
    </message>
    <message>
      <source>Views stitched again. The choice is saved with the project.</source>
      <translation>视图已重新拼接。选择随项目保存。</translation>
    </message>
    <message>
      <source>Views used</source>
      <translation>使用的视图</translation>
    </message>
    <message>
      <source>Wait until it is loaded, or use recorded images.</source>
      <translation>请等待加载完成，或使用录制的图像。</translation>
    </message>
    <message>
      <source>Without a CAD model a hole pattern is made from circles: create two or more, select them in the list, then choose Hole pattern.</source>
      <translation>没有 CAD 模型时，孔组由圆构成：先创建两个或更多圆，在列表中选中它们，再选择“孔组”。</translation>
    </message>
    <message>
      <source>Writing the report</source>
      <translation>正在生成报告</translation>
    </message>
    <message>
      <source>Writing the report of repeats</source>
      <translation>正在生成重复测量报告</translation>
    </message>
    <message>
      <source>Writing the report of the series</source>
      <translation>正在生成系列报告</translation>
    </message>
    <message>
      <source>Wrong PIN.</source>
      <translation>PIN 错误。</translation>
    </message>
    <message>
      <source>Wrong part: the code is of part {part}, this program measures part {part_number}.</source>
      <translation>工件不符：代码属于工件 {part}，此程序测量工件 {part_number}。</translation>
    </message>
    <message>
      <source>Your own: {name}, version {version}</source>
      <translation>您自己的：{name}，版本 {version}</translation>
    </message>
    <message>
      <source>a layout (Typst)</source>
      <translation>版式 (Typst)</translation>
    </message>
    <message>
      <source>best fit circle</source>
      <translation>拟合圆</translation>
    </message>
    <message>
      <source>best fit line</source>
      <translation>拟合直线</translation>
    </message>
    <message>
      <source>best fit plane</source>
      <translation>拟合平面</translation>
    </message>
    <message>
      <source>common datum</source>
      <translation>公共基准</translation>
    </message>
    <message>
      <source>earlier images kept</source>
      <translation>保留了先前的图像</translation>
    </message>
    <message>
      <source>hole pattern</source>
      <translation>孔组</translation>
    </message>
    <message>
      <source>job: {title}</source>
      <translation>任务：{title}</translation>
    </message>
    <message>
      <source>midplane</source>
      <translation>中间平面</translation>
    </message>
    <message>
      <source>no board</source>
      <translation>没有标定板</translation>
    </message>
    <message>
      <source>no reason stated</source>
      <translation>未说明原因</translation>
    </message>
    <message>
      <source>not measured</source>
      <translation>未测量</translation>
    </message>
    <message>
      <source>not proven</source>
      <translation>未证实</translation>
    </message>
    <message>
      <source>offset plane</source>
      <translation>偏置平面</translation>
    </message>
    <message>
      <source>point on axis</source>
      <translation>轴上的点</translation>
    </message>
    <message>
      <source>projection</source>
      <translation>投影</translation>
    </message>
    <message>
      <source>statistics of the deviations</source>
      <translation>偏差统计</translation>
    </message>
    <message>
      <source>stop the rig</source>
      <translation>停止测量系统</translation>
    </message>
    <message>
      <source>thing prevents</source>
      <translation>项问题阻止</translation>
    </message>
    <message>
      <source>things prevent</source>
      <translation>项问题阻止</translation>
    </message>
    <message>
      <source>viewpoint measures</source>
      <translation>个视点测量</translation>
    </message>
    <message>
      <source>viewpoints measure</source>
      <translation>个视点测量</translation>
    </message>
    <message>
      <source>without serial number</source>
      <translation>无序列号</translation>
    </message>
    <message>
      <source>wrong part</source>
      <translation>工件不符</translation>
    </message>
    <message>
      <source>{counted} of {before} points removed.</source>
      <translation>从 {before} 个点中去除了 {counted} 个。</translation>
    </message>
    <message>
      <source>{count} of {of} clouds kept as they were.</source>
      <translation>保留 {count}/{of} 个点云，未作改动。</translation>
    </message>
    <message>
      <source>{count} of {of} clouds kept, placed anew.</source>
      <translation>保留 {count}/{of} 个点云，并重新定位。</translation>
    </message>
    <message>
      <source>{count} of {total}</source>
      <translation>{count} / {total}</translation>
    </message>
    <message>
      <source>{count} the scan.</source>
      <translation>{count}扫描。</translation>
    </message>
    <message>
      <source>{count} viewpoints are too many to be ordered.</source>
      <translation>{count} 个视点太多，无法排序。</translation>
    </message>
    <message>
      <source>{count} {planned_share} of the surface, {planned_of_allowed} of what the rig can.</source>
      <translation>{count} 占表面的 {planned_share}，占测量系统可测部分的 {planned_of_allowed}。</translation>
    </message>
    <message>
      <source>{decodable_share} of the lit pixels decodable, {planned_share} as planned</source>
      <translation>照亮像素中 {decodable_share} 可解码，按计划为 {planned_share}</translation>
    </message>
    <message>
      <source>{folder} cannot be written to: {value}.</source>
      <translation>无法写入 {folder}：{value}。</translation>
    </message>
    <message>
      <source>{folder} holds no calibration of cameras or a rig.</source>
      <translation>{folder} 中没有相机或测量系统的标定。</translation>
    </message>
    <message>
      <source>{name} added to the inspection program.</source>
      <translation>{name} 已添加到检测程序。</translation>
    </message>
    <message>
      <source>{name} has no calibration.</source>
      <translation>{name} 没有标定。</translation>
    </message>
    <message>
      <source>{name} is open read-only: it is in use by {holder}.</source>
      <translation>{name} 以只读方式打开：{holder} 正在使用。</translation>
    </message>
    <message>
      <source>{name} is open.</source>
      <translation>{name} 已打开。</translation>
    </message>
    <message>
      <source>{name} is open: {count} viewpoints.</source>
      <translation>{name} 已打开：{count} 个视点。</translation>
    </message>
    <message>
      <source>{name} removed from the inspection program.</source>
      <translation>{name} 已从检测程序中移除。</translation>
    </message>
    <message>
      <source>{name} saved to {parent}.</source>
      <translation>{name} 已保存到 {parent}。</translation>
    </message>
    <message>
      <source>{name} was inspected against {name_2}.</source>
      <translation>{name} 已按 {name_2} 检测。</translation>
    </message>
    <message>
      <source>{name}, version {version}</source>
      <translation>{name}，版本 {version}</translation>
    </message>
    <message>
      <source>{threads} thread in place of {usual} detects the board: these would need about {needed} GiB of memory, and {available} GiB are available.</source>
      <translation>由 {threads} 个线程代替 {usual} 个检测标定板：后者约需 {needed} GiB 内存，可用内存为 {available} GiB。</translation>
    </message>
    <message>
      <source>{title} is still running.</source>
      <translation>{title}仍在运行。</translation>
    </message>
    <message>
      <source>{where} of {times} ms chosen by a probe: {figures}.</source>
      <translation>{where}：{times} ms，由试测选择：{figures}。</translation>
    </message>
    <message>
      <source>{why} Click where more was measured, or change the values.</source>
      <translation>{why}请单击测量点较多之处，或修改数值。</translation>
    </message>
    <message>
      <source>{words} Not saved with the project: {message}</source>
      <translation>{words} 未随项目保存：{message}</translation>
    </message>
  </context>
  <context>
    <name>core.acquire</name>
    <message>
      <source>A camera</source>
      <translation>某台相机</translation>
    </message>
    <message>
      <source>A controller</source>
      <translation>某台控制器</translation>
    </message>
    <message>
      <source>A step of {v1}{v2} by hand is too large.</source>
      <translation>手动单步 {v1}{v2} 过大。</translation>
    </message>
    <message>
      <source>Camera {v1} is saturated even at {v2} µs.</source>
      <translation>相机 {v1} 在 {v2} µs 时仍饱和。</translation>
    </message>
    <message>
      <source>Check for a collision or a protective stop, then repeat the viewpoint.</source>
      <translation>请检查是否发生碰撞或保护性停止，然后重做该视点。</translation>
    </message>
    <message>
      <source>Check its power and cable, and connect the rig again.</source>
      <translation>请检查其电源和电缆，然后重新连接测量系统。</translation>
    </message>
    <message>
      <source>Check its power and cable, and connect the rig again; if it happens again, report it to the author of the driver.</source>
      <translation>请检查其电源和电缆，然后重新连接测量系统；若再次发生，请报告驱动的作者。</translation>
    </message>
    <message>
      <source>Check projector, trigger lines and ambient light.</source>
      <translation>请检查投影仪、触发线和环境光。</translation>
    </message>
    <message>
      <source>Check the drives and the brakes, then repeat the viewpoint.</source>
      <translation>请检查驱动器和制动器，然后重做该视点。</translation>
    </message>
    <message>
      <source>Check the guide, then repeat the viewpoint.</source>
      <translation>请检查导轨，然后重做该视点。</translation>
    </message>
    <message>
      <source>Check the projector's lamp and ambient light.</source>
      <translation>请检查投影仪的灯和环境光。</translation>
    </message>
    <message>
      <source>Check the projector's lamp and lens cap, and the viewpoint.</source>
      <translation>请检查投影仪的灯和镜头盖，以及该视点。</translation>
    </message>
    <message>
      <source>Check the table, then repeat the viewpoint.</source>
      <translation>请检查转台，然后重做该视点。</translation>
    </message>
    <message>
      <source>Choose at most {v1}{v2}.</source>
      <translation>请选择不超过 {v1}{v2} 的步长。</translation>
    </message>
    <message>
      <source>Images of the board from {v1}</source>
      <translation>来自 {v1} 的标定板图像</translation>
    </message>
    <message>
      <source>It is taken again at the end of the run.</source>
      <translation>运行结束时会重新拍摄它。</translation>
    </message>
    <message>
      <source>Make it ready, then resume the run.</source>
      <translation>请使其就绪，然后继续运行。</translation>
    </message>
    <message>
      <source>Name a viewpoint of the plan.</source>
      <translation>请指定计划中的视点。</translation>
    </message>
    <message>
      <source>No viewpoint is left to be skipped.</source>
      <translation>没有可跳过的视点。</translation>
    </message>
    <message>
      <source>Paused by the user.</source>
      <translation>已由用户暂停。</translation>
    </message>
    <message>
      <source>Point the cameras at a stationary surface (--plan), and check the projector.</source>
      <translation>请将相机对准静止表面 (--plan)，并检查投影仪。</translation>
    </message>
    <message>
      <source>Reduce the light, or close the aperture.</source>
      <translation>请减弱光线，或缩小光圈。</translation>
    </message>
    <message>
      <source>Resume the run to go on.</source>
      <translation>请继续运行。</translation>
    </message>
    <message>
      <source>Set sequence = "software" in [head] of the rig description.</source>
      <translation>请在测量系统描述的 [head] 中设置 sequence = "software"。</translation>
    </message>
    <message>
      <source>Skip a viewpoint that is still to be taken.</source>
      <translation>请跳过尚未拍摄的视点。</translation>
    </message>
    <message>
      <source>Start it again to take further viewpoints.</source>
      <translation>请再次启动以拍摄更多视点。</translation>
    </message>
    <message>
      <source>Start the run again.</source>
      <translation>请重新启动运行。</translation>
    </message>
    <message>
      <source>The camera delivers stale images: check its trigger line and its driver.</source>
      <translation>相机送出过期图像：请检查其触发线和驱动。</translation>
    </message>
    <message>
      <source>The control of a run cannot be used for another one.</source>
      <translation>一次运行的控制不能用于另一次。</translation>
    </message>
    <message>
      <source>The image of camera {v1} is dark at {v2} µs.</source>
      <translation>相机 {v1} 的图像在 {v2} µs 时过暗。</translation>
    </message>
    <message>
      <source>The images of {v1} are in memory; they are stored first when the run goes on.</source>
      <translation>{v1} 的图像在内存中；运行继续时会先存储它们。</translation>
    </message>
    <message>
      <source>The linear guide</source>
      <translation>直线导轨</translation>
    </message>
    <message>
      <source>The measuring head</source>
      <translation>测头</translation>
    </message>
    <message>
      <source>The projector</source>
      <translation>投影仪</translation>
    </message>
    <message>
      <source>The rig {v1} is in use by another task.</source>
      <translation>测量系统 {v1} 正被另一任务使用。</translation>
    </message>
    <message>
      <source>The robot</source>
      <translation>机器人</translation>
    </message>
    <message>
      <source>The rotary table</source>
      <translation>转台</translation>
    </message>
    <message>
      <source>The run has ended.</source>
      <translation>运行已结束。</translation>
    </message>
    <message>
      <source>The run has no viewpoint {v1}.</source>
      <translation>运行中没有视点 {v1}。</translation>
    </message>
    <message>
      <source>The run has not started yet.</source>
      <translation>运行尚未开始。</translation>
    </message>
    <message>
      <source>Viewpoint {v1} cannot be skipped: it is {v2}.</source>
      <translation>视点 {v1} 不能跳过：{v2}。</translation>
    </message>
    <message>
      <source>Viewpoint {v1} is being taken.</source>
      <translation>正在拍摄视点 {v1}。</translation>
    </message>
    <message>
      <source>Wait until it is stored.</source>
      <translation>请等待其存储完成。</translation>
    </message>
    <message>
      <source>Wait until it moves.</source>
      <translation>请等待其移动。</translation>
    </message>
    <message>
      <source>Wait until that has finished, or stop it.</source>
      <translation>请等待其完成，或停止。</translation>
    </message>
    <message>
      <source>a run that is {v1} cannot become {v2}</source>
      <translation>状态为 {v1} 的运行不能变为 {v2}</translation>
    </message>
    <message>
      <source>cancelled by the user.</source>
      <translation>已由用户取消。</translation>
    </message>
    <message>
      <source>exposure {v1} ms</source>
      <translation>曝光 {v1} ms</translation>
    </message>
    <message>
      <source>noise of camera {v1}</source>
      <translation>相机 {v1} 的噪声</translation>
    </message>
    <message>
      <source>probe: image {v1} at {v2} ms</source>
      <translation>试测：图像 {v1}，{v2} ms</translation>
    </message>
    <message>
      <source>viewpoint {v1}, which is {v2}, cannot become {v3}</source>
      <translation>状态为 {v2} 的视点 {v1} 不能变为 {v3}</translation>
    </message>
    <message>
      <source>{v1} ({v2}) is not ready: {v3} {v4}</source>
      <translation>{v1}（{v2}）未就绪：{v3} {v4}</translation>
    </message>
    <message>
      <source>{v1} It is tried once more at the end of the run.</source>
      <translation>{v1} 运行结束时会再试一次。</translation>
    </message>
    <message>
      <source>{v1} The images stored before are kept.</source>
      <translation>{v1} 此前存储的图像已保留。</translation>
    </message>
    <message>
      <source>{v1} cannot trigger cameras, as the hardware sequence of {v2} needs.</source>
      <translation>{v1} 不能触发相机，而 {v2} 的硬件序列需要触发。</translation>
    </message>
    <message>
      <source>{v1} does not answer any more.</source>
      <translation>{v1} 不再应答。</translation>
    </message>
    <message>
      <source>{v1} failed: {v2}: {v3}.</source>
      <translation>{v1} 失败：{v2}：{v3}。</translation>
    </message>
    <message>
      <source>{v1} of {v2} viewpoints are stored and kept; not {v3}. Continue the run to take the missing ones.</source>
      <translation>{v2} 个视点中有 {v1} 个已存储并保留；未存储：{v3}。请继续运行以拍摄缺少的视点。</translation>
    </message>
    <message>
      <source>{v1}: image {v2} at {v3} ms</source>
      <translation>{v1}：图像 {v2}，{v3} ms</translation>
    </message>
    <message>
      <source>{v1}: image {v2} of camera {v3} at {v4} µs is an image of {v5}.</source>
      <translation>{v1}：相机 {v3} 在 {v4} µs 下的图像 {v2} 是 {v5} 的图像。</translation>
    </message>
    <message>
      <source>{v1}: no camera sees fringes: the projector was dark, or nothing is in view.</source>
      <translation>{v1}：没有相机看到条纹：投影仪不亮，或视野中没有物体。</translation>
    </message>
    <message>
      <source>{v1}: the guide stopped at {v2} mm.</source>
      <translation>{v1}：导轨停在 {v2} mm 处。</translation>
    </message>
    <message>
      <source>{v1}: the light changed by {v2} between the patterns at {v3} µs (camera {v4}).</source>
      <translation>{v1}：{v3} µs 曝光的图案之间，光强变化了 {v2}（相机 {v4}）。</translation>
    </message>
    <message>
      <source>{v1}: the robot stopped away from its goal, by {v2} mm and {v3}°.</source>
      <translation>{v1}：机器人停止时偏离目标 {v2} mm、{v3}°。</translation>
    </message>
    <message>
      <source>{v1}: the table stopped at {v2}°.</source>
      <translation>{v1}：转台停在 {v2}° 处。</translation>
    </message>
    <message>
      <source>{v1}: the {v2} moved while images were taken.</source>
      <translation>{v1}：拍摄图像期间{v2}发生了移动。</translation>
    </message>
    <message>
      <source>{v1}: {v2} It was tried {v3} times.</source>
      <translation>{v1}：{v2} 已尝试 {v3} 次。</translation>
    </message>
  </context>
  <context>
    <name>core.actions</name>
    <message>
      <source>the action {v1} is registered twice</source>
      <translation>操作 {v1} 注册了两次</translation>
    </message>
    <message>
      <source>{v1} and {v2} have the same shortcut {v3}</source>
      <translation>{v1} 与 {v2} 的快捷键同为 {v3}</translation>
    </message>
  </context>
  <context>
    <name>core.arrays</name>
    <message>
      <source>expected an array of shape {v1}, got {v2}</source>
      <translation>应为形状 {v1} 的数组，实际为 {v2}</translation>
    </message>
  </context>
  <context>
    <name>core.axis_modbus</name>
    <message>
      <source>Check for an obstacle, a limit switch, and the scale of the drive.</source>
      <translation>请检查障碍物、限位开关和驱动器的比例。</translation>
    </message>
    <message>
      <source>Check its emergency stop, its supply and its interlocks.</source>
      <translation>请检查其急停、电源和联锁。</translation>
    </message>
    <message>
      <source>Check port or address, cable and power, and that no other program uses it.</source>
      <translation>请检查端口或地址、电缆和电源，并确认没有其他程序使用。</translation>
    </message>
    <message>
      <source>Check power, cable, station number and baud rate.</source>
      <translation>请检查电源、电缆、站号和波特率。</translation>
    </message>
    <message>
      <source>Check power, cable, station number and baud rate; connect again, and find the reference anew if the drive lost it.</source>
      <translation>请检查电源、电缆、站号和波特率；重新连接，若驱动器丢失参考点，请重新回参考点。</translation>
    </message>
    <message>
      <source>Check speed, counts_per_unit, zero_counts and the map of the drive; nothing was moved.</source>
      <translation>请检查速度、counts_per_unit、zero_counts 和驱动器映射表；未作任何移动。</translation>
    </message>
    <message>
      <source>Check station number, port and drive map.</source>
      <translation>请检查站号、端口和驱动器映射表。</translation>
    </message>
    <message>
      <source>Check that the map fits this drive, and the state of the drive.</source>
      <translation>请检查映射表是否适合此驱动器，以及驱动器状态。</translation>
    </message>
    <message>
      <source>Check the map of the drive, and that no other program commands it.</source>
      <translation>请检查驱动器映射表，并确认没有其他程序在控制它。</translation>
    </message>
    <message>
      <source>Check the map of the drive.</source>
      <translation>请检查驱动器的映射表。</translation>
    </message>
    <message>
      <source>Choose a goal inside the limits; nothing was moved.</source>
      <translation>请选择限位以内的目标；未作任何移动。</translation>
    </message>
    <message>
      <source>Correct the file.</source>
      <translation>请更正文件。</translation>
    </message>
    <message>
      <source>Correct this field; the README describes the form.</source>
      <translation>请更正此字段；README 说明了格式。</translation>
    </message>
    <message>
      <source>Find its reference before it is moved.</source>
      <translation>移动前请先寻找参考点。</translation>
    </message>
    <message>
      <source>Name one of {v1}, or the path of a map (.toml).</source>
      <translation>请指定 {v1} 之一，或映射表 (.toml) 的路径。</translation>
    </message>
    <message>
      <source>Remove the cause and reset the drive, then {v1}.</source>
      <translation>请排除原因并复位驱动器，然后{v1}。</translation>
    </message>
    <message>
      <source>There is no drive map {v1}.</source>
      <translation>没有驱动器映射表 {v1}。</translation>
    </message>
    <message>
      <source>[links]: {v1}.</source>
      <translation>[links]：{v1}。</translation>
    </message>
    <message>
      <source>code {v1}</source>
      <translation>代码 {v1}</translation>
    </message>
    <message>
      <source>conditions.moving or conditions.in_position is needed to know when a move has ended</source>
      <translation>需要 conditions.moving 或 conditions.in_position 才能知道移动何时结束</translation>
    </message>
    <message>
      <source>connect again</source>
      <translation>重新连接</translation>
    </message>
    <message>
      <source>does not know this function</source>
      <translation>不支持此功能</translation>
    </message>
    <message>
      <source>failed while executing the request</source>
      <translation>执行请求时失败</translation>
    </message>
    <message>
      <source>give either equals or differs</source>
      <translation>请给出 equals 或 differs 之一</translation>
    </message>
    <message>
      <source>has no such register</source>
      <translation>没有此寄存器</translation>
    </message>
    <message>
      <source>is busy</source>
      <translation>正忙</translation>
    </message>
    <message>
      <source>is not reached by the gateway</source>
      <translation>无法由网关访问</translation>
    </message>
    <message>
      <source>received nothing</source>
      <translation>未收到任何数据</translation>
    </message>
    <message>
      <source>received {v1}{v2}</source>
      <translation>收到 {v1}{v2}</translation>
    </message>
    <message>
      <source>refused the request</source>
      <translation>拒绝了该请求</translation>
    </message>
    <message>
      <source>refuses this value</source>
      <translation>拒绝此值</translation>
    </message>
    <message>
      <source>registers.{v1} is not described</source>
      <translation>registers.{v1} 没有描述</translation>
    </message>
    <message>
      <source>see the drive</source>
      <translation>查看驱动器</translation>
    </message>
    <message>
      <source>sequences.move writes no goal</source>
      <translation>sequences.move 没有写入目标</translation>
    </message>
    <message>
      <source>sequences.{v1} is not described</source>
      <translation>sequences.{v1} 没有描述</translation>
    </message>
    <message>
      <source>the drive map</source>
      <translation>驱动器映射表</translation>
    </message>
    <message>
      <source>the line</source>
      <translation>线路</translation>
    </message>
    <message>
      <source>the line was closed</source>
      <translation>线路已关闭</translation>
    </message>
    <message>
      <source>{v1} (station {v2} at {v3}) did not reply ({v4}).</source>
      <translation>{v1}（{v3} 上的站 {v2}）没有应答（{v4}）。</translation>
    </message>
    <message>
      <source>{v1} (station {v2} at {v3}) does not answer any more: {v4}.</source>
      <translation>{v1}（{v3} 上的站 {v2}）不再应答：{v4}。</translation>
    </message>
    <message>
      <source>{v1} (station {v2} at {v3}) {v4} (Modbus exception {v5}).</source>
      <translation>{v1}（站 {v2}，{v3}）{v4}（Modbus 异常 {v5}）。</translation>
    </message>
    <message>
      <source>{v1} answered {v2} instead of {v3} registers ({v4}).</source>
      <translation>{v1} 返回 {v2} 个寄存器，而非 {v3} 个 ({v4})。</translation>
    </message>
    <message>
      <source>{v1} came to rest {v2} away from its goal.</source>
      <translation>{v1} 停止时偏离目标 {v2}。</translation>
    </message>
    <message>
      <source>{v1} cannot be opened.</source>
      <translation>无法打开 {v1}。</translation>
    </message>
    <message>
      <source>{v1} cannot be read as a drive map: {v2}.</source>
      <translation>无法将 {v1} 读作驱动器映射表：{v2}。</translation>
    </message>
    <message>
      <source>{v1} does not switch its servo on.</source>
      <translation>{v1} 无法接通伺服。</translation>
    </message>
    <message>
      <source>{v1} has another goal than was sent.</source>
      <translation>{v1} 的目标与发送的不同。</translation>
    </message>
    <message>
      <source>{v1} is not referenced.</source>
      <translation>{v1} 未回参考点。</translation>
    </message>
    <message>
      <source>{v1} reports an alarm: {v2}.</source>
      <translation>{v1} 报警：{v2}。</translation>
    </message>
    <message>
      <source>{v1}: register {v2} reads {v3}, which is not a {v4}.</source>
      <translation>{v1}：寄存器 {v2} 为 {v3}，不是 {v4}。</translation>
    </message>
    <message>
      <source>{v1}: the goal {v2}{v3} is outside {v4}…{v5}{v6}.</source>
      <translation>{v1}：目标 {v2}{v3} 超出 {v4}…{v5}{v6}。</translation>
    </message>
    <message>
      <source>{v1}: {v2} does not fit the register {v3} ({v4}…{v5}).</source>
      <translation>{v1}：{v2} 超出寄存器 {v3} 的范围（{v4}…{v5}）。</translation>
    </message>
  </context>
  <context>
    <name>core.calibrate</name>
    <message>
      <source> Used from other robot poses, robot and hand–eye add {v1} (k = 2).</source>
      <translation> 在其他机器人位姿下使用时，机器人与手眼关系增加 {v1} (k = 2)。</translation>
    </message>
    <message>
      <source> {v1} were rejected because they fit badly.</source>
      <translation>{v1} 因拟合不良被剔除。</translation>
    </message>
    <message>
      <source>, beyond what is stated of it ({v1})</source>
      <translation>，超出对其所声明的范围（{v1}）</translation>
    </message>
    <message>
      <source>, which was calibrated as {v1}</source>
      <translation>，标定时为 {v1}</translation>
    </message>
    <message>
      <source>, {v1} mm at {v2} mm from the head</source>
      <translation>，距测头 {v2} mm 处为 {v1} mm</translation>
    </message>
    <message>
      <source>1 image</source>
      <translation>1 幅图像</translation>
    </message>
    <message>
      <source>A camera is called {v1}.</source>
      <translation>有相机名为 {v1}。</translation>
    </message>
    <message>
      <source>A folder with images such as left01.png, right01.png: images with the same number show the same position of the board.</source>
      <translation>含 left01.png、right01.png 等图像的文件夹：编号相同的图像显示标定板的同一位置。</translation>
    </message>
    <message>
      <source>A folder with one folder per position of the board, each with its fringe images of both directions and a MANIFEST.toml.</source>
      <translation>每个标定板位置一个子文件夹，各含两个方向的条纹图像和 MANIFEST.toml。</translation>
    </message>
    <message>
      <source>A {v1} is symmetric under half a turn, so {v2} cannot use it.</source>
      <translation>{v1} 在半转下对称，因此 {v2} 不能使用。</translation>
    </message>
    <message>
      <source>About {v1} times as many observations, as different from each other, would make it good.</source>
      <translation>约需 {v1} 倍数量、彼此差异同样大的观测，结果才会良好。</translation>
    </message>
    <message>
      <source>According to its angles the table turned by {v1}°, but the board turned by {v2}°.</source>
      <translation>按其角度转台转动了 {v1}°，但标定板转动了 {v2}°。</translation>
    </message>
    <message>
      <source>Add a position near {v1}{v2}: there is none between {v3}{v4} and {v5}{v6}</source>
      <translation>在 {v1}{v2} 附近增加一个位置：{v3}{v4} 与 {v5}{v6} 之间没有位置</translation>
    </message>
    <message>
      <source>Add observations from other distances, tilts and positions.</source>
      <translation>请添加其他距离、倾斜和位置的观测。</translation>
    </message>
    <message>
      <source>Add observations that show it.</source>
      <translation>请添加显示它的观测。</translation>
    </message>
    <message>
      <source>Add poses turned about a second axis, best at right angles to it.</source>
      <translation>请添加绕第二轴转动的位姿，最好与之垂直。</translation>
    </message>
    <message>
      <source>Add poses turned about different axes.</source>
      <translation>请添加绕不同轴转动的位姿。</translation>
    </message>
    <message>
      <source>Add poses turned by 20° to 90° about different axes.</source>
      <translation>请添加绕不同轴转动 20° 至 90° 的位姿。</translation>
    </message>
    <message>
      <source>Add poses with larger rotations and translations.</source>
      <translation>请添加旋转和平移更大的位姿。</translation>
    </message>
    <message>
      <source>Add sharp views with the board tilted in different directions.</source>
      <translation>请添加标定板向不同方向倾斜的清晰视图。</translation>
    </message>
    <message>
      <source>Add views in which both it and another camera see the whole board.</source>
      <translation>请添加它与另一相机都看到整块标定板的视图。</translation>
    </message>
    <message>
      <source>Add views with the board tilted in different directions.</source>
      <translation>请添加标定板向不同方向倾斜的视图。</translation>
    </message>
    <message>
      <source>Adds {v1} (k = 2), at worst {v2}, to a length of {v3} mm in this volume</source>
      <translation>在此体积内给 {v3} mm 的长度增加 {v1} (k = 2)，最差 {v2}</translation>
    </message>
    <message>
      <source>Adds {v1} (k = 2), at worst {v2}, to a length of {v3} mm measured by camera {v4} and the projector</source>
      <translation>给由相机 {v4} 和投影仪测得的 {v3} mm 长度增加 {v1} (k = 2)，最差 {v2}</translation>
    </message>
    <message>
      <source>All motions turn about nearly the same axis of the flange ({v1}; {v2}° from parallel): the camera's position along that axis is not observable.</source>
      <translation>所有运动几乎绕法兰的同一轴转动（{v1}；与平行相差 {v2}°）：相机沿该轴的位置不可观测。</translation>
    </message>
    <message>
      <source>Bring the board to the borders of the projector's image, not only of the camera images.</source>
      <translation>请将标定板移到投影图像的边缘，而不仅是相机图像的边缘。</translation>
    </message>
    <message>
      <source>Calibrate hand-eye first.</source>
      <translation>请先标定手眼。</translation>
    </message>
    <message>
      <source>Calibrate hand–eye</source>
      <translation>标定手眼</translation>
    </message>
    <message>
      <source>Calibrate it: `measureapp calibrate projector`.</source>
      <translation>请标定：`measureapp calibrate projector`。</translation>
    </message>
    <message>
      <source>Calibrate the cameras</source>
      <translation>标定相机</translation>
    </message>
    <message>
      <source>Calibrate the cameras first.</source>
      <translation>请先标定相机。</translation>
    </message>
    <message>
      <source>Calibrate the cameras with 4, 5 or 8 coefficients.</source>
      <translation>请用 4、5 或 8 个系数标定相机。</translation>
    </message>
    <message>
      <source>Calibrate the linear guide</source>
      <translation>标定直线导轨</translation>
    </message>
    <message>
      <source>Calibrate the projector</source>
      <translation>标定投影仪</translation>
    </message>
    <message>
      <source>Calibrate the table axis</source>
      <translation>标定转台轴线</translation>
    </message>
    <message>
      <source>Calibrate the whole rig</source>
      <translation>标定整个测量系统</translation>
    </message>
    <message>
      <source>Calibrate the whole rig first.</source>
      <translation>请先标定整个测量系统。</translation>
    </message>
    <message>
      <source>Camera drift check: passed; none is off by more than {v1}, and the calibration left {v2} px.</source>
      <translation>相机漂移检查：通过；偏差均不超过 {v1}，标定的残差为 {v2} px。</translation>
    </message>
    <message>
      <source>Camera {v1} has no images yet.</source>
      <translation>相机 {v1} 尚无图像。</translation>
    </message>
    <message>
      <source>Camera {v1} has no view of the board in common with the other cameras.</source>
      <translation>相机 {v1} 没有与其他相机共同的标定板视图。</translation>
    </message>
    <message>
      <source>Camera {v1} has {v2} usable views of the board; at least {v3} are needed.{v4}</source>
      <translation>相机 {v1} 有 {v2} 个可用的标定板视图；至少需要 {v3} 个。{v4}</translation>
    </message>
    <message>
      <source>Camera {v1} has {v2} views left that fit the others; at least {v3} are needed.</source>
      <translation>相机 {v1} 只剩 {v2} 个与其他一致的视图；至少需要 {v3} 个。</translation>
    </message>
    <message>
      <source>Camera {v1} is not calibrated.</source>
      <translation>相机 {v1} 未标定。</translation>
    </message>
    <message>
      <source>Cameras {v1} and {v2}</source>
      <translation>相机 {v1} 和 {v2}</translation>
    </message>
    <message>
      <source>Cameras, hand–eye, linear guide and table axis in one automatic run</source>
      <translation>一次自动运行标定相机、手眼、直线导轨和转台轴线</translation>
    </message>
    <message>
      <source>Check its numbers of corners, and `legacy_pattern` for a board drawn by OpenCV before 4.6.</source>
      <translation>请检查其角点数；若标定板由 4.6 之前的 OpenCV 绘制，请检查 `legacy_pattern`。</translation>
    </message>
    <message>
      <source>Check that guide positions and poses are in mm, in the same order, and that the board did not move.</source>
      <translation>请检查导轨位置和位姿是否以 mm 为单位、顺序一致，且标定板未移动。</translation>
    </message>
    <message>
      <source>Check that no two cameras are exchanged, that images of one position belong together, and that the board's size is right.</source>
      <translation>请检查相机是否互换、同一位置的图像是否相互对应，以及标定板的尺寸是否正确。</translation>
    </message>
    <message>
      <source>Check that robot and board poses are in the same order, and that the rotations are unit quaternions, not degrees.</source>
      <translation>请检查机器人与标定板位姿顺序是否一致，旋转是否为单位四元数而非角度。</translation>
    </message>
    <message>
      <source>Check that the board is fixed on the table, and that tables and images are in the same order.</source>
      <translation>请检查标定板是否固定在转台上，表格与图像顺序是否一致。</translation>
    </message>
    <message>
      <source>Check that the images show the same rigid board, sharp and in the same order for all cameras.</source>
      <translation>请检查图像是否显示同一刚性标定板，清晰且各相机顺序一致。</translation>
    </message>
    <message>
      <source>Check the board's size, its dictionary and that nothing mirrors the image.</source>
      <translation>请检查标定板的尺寸和字典，并确认图像未被镜像。</translation>
    </message>
    <message>
      <source>Check the order of the positions, the unit (degrees) of the angles, and that the board did not move on the table.</source>
      <translation>请检查位置顺序、角度单位（度），且标定板未在转台上移动。</translation>
    </message>
    <message>
      <source>Check the size of the board: its squares seem to be {v1} times as large as stated.</source>
      <translation>请检查标定板的尺寸：其方格似乎是所述的 {v1} 倍。</translation>
    </message>
    <message>
      <source>Check the unit (degrees) and the order of the table angles, and that the board did not move on the table.</source>
      <translation>请检查转台角度的单位（度）和顺序，且标定板未在转台上移动。</translation>
    </message>
    <message>
      <source>Choose 4, 5 or 8.</source>
      <translation>请选择 4、5 或 8。</translation>
    </message>
    <message>
      <source>Choose one of: </source>
      <translation>请选择其一：</translation>
    </message>
    <message>
      <source>Choose one of: {v1}.</source>
      <translation>请从以下选择：{v1}。</translation>
    </message>
    <message>
      <source>Choose the calibration of these cameras as they are set now, or calibrate them.</source>
      <translation>请选择这些相机当前设置的标定，或标定它们。</translation>
    </message>
    <message>
      <source>Compare axes in the same frame.</source>
      <translation>请比较同一坐标系中的轴线。</translation>
    </message>
    <message>
      <source>Compare calibrations of the same cameras.</source>
      <translation>请比较相同相机的标定。</translation>
    </message>
    <message>
      <source>Cover the images to their borders and corners: lens distortion is largest there.</source>
      <translation>请覆盖图像直至边缘和角落：那里镜头畸变最大。</translation>
    </message>
    <message>
      <source>Coverage of the image</source>
      <translation>图像的覆盖</translation>
    </message>
    <message>
      <source>Describe it as a ChArUco board with its dictionary.</source>
      <translation>请将其描述为带有相应字典的 ChArUco 标定板。</translation>
    </message>
    <message>
      <source>Determines direction and scale of the guide, with cameras and hand–eye as calibrated. Fix the board on the table; the guide moves the robot past it.</source>
      <translation>以已标定的相机和手眼确定导轨的方向和比例。将标定板固定在转台上；导轨使机器人从旁经过。</translation>
    </message>
    <message>
      <source>Determines lens and pose of every camera from images of a board seen from many sides. Fill the images to their borders, and tilt the board.</source>
      <translation>由多个方向看到的标定板图像确定每台相机的镜头和位姿。请充满图像直至边缘，并倾斜标定板。</translation>
    </message>
    <message>
      <source>Determines lens and pose of the projector from fringes of both directions on the board, with the cameras as calibrated. The phases around a corner of the board identify the projector pixel that lights it.</source>
      <translation>以已标定的相机，由标定板上两个方向的条纹确定投影仪的镜头和位姿。标定板角点周围的相位确定照亮它的投影仪像素。</translation>
    </message>
    <message>
      <source>Determines the pose of the head on the flange, with the cameras as calibrated. Fix the board on the table; the robot turns the head.</source>
      <translation>以已标定的相机确定测头在法兰上的位姿。将标定板固定在转台上；机器人转动测头。</translation>
    </message>
    <message>
      <source>Determines the table's axis, with cameras and robot as calibrated. Fix the board on the table; the table turns it.</source>
      <translation>以已标定的相机和机器人确定转台轴线。将标定板固定在转台上；转台转动它。</translation>
    </message>
    <message>
      <source>Direction and scale of the guide</source>
      <translation>导轨的方向和比例</translation>
    </message>
    <message>
      <source>Every camera needs a name of its own.</source>
      <translation>每台相机须有自己的名称。</translation>
    </message>
    <message>
      <source>Fix the board on the table so that it cannot slip.</source>
      <translation>将标定板固定在转台上，使其不会滑动。</translation>
    </message>
    <message>
      <source>Fix the board on the table. The rig views it from all sides, moves along the guide and turns the table, and everything is solved together.</source>
      <translation>将标定板固定在转台上。测量系统从各个方向观察它，沿导轨移动并转动转台，一并求解。</translation>
    </message>
    <message>
      <source>Flange and camera turn by different angles (median difference {v1}°).</source>
      <translation>法兰与相机转动的角度不同（中位差 {v1}°）。</translation>
    </message>
    <message>
      <source>Focal length x</source>
      <translation>焦距 x</translation>
    </message>
    <message>
      <source>Focal length y</source>
      <translation>焦距 y</translation>
    </message>
    <message>
      <source>Focal length, image centre, distortion and pose of every camera</source>
      <translation>每台相机的焦距、图像中心、畸变和位姿</translation>
    </message>
    <message>
      <source>Focus the camera, and keep board and camera still while the image is taken.</source>
      <translation>请对焦相机，拍摄图像时保持标定板和相机静止。</translation>
    </message>
    <message>
      <source>Give at least 3, better 10 or more.</source>
      <translation>请至少给出 3 个，最好 10 个以上。</translation>
    </message>
    <message>
      <source>Give at least {v1} positions of at least 3 corners.</source>
      <translation>请至少给出 {v1} 个位置，每个至少 3 个角点。</translation>
    </message>
    <message>
      <source>Give at least {v1} positions over {v2} mm or more.</source>
      <translation>请至少给出 {v1} 个位置，跨越 {v2} mm 以上。</translation>
    </message>
    <message>
      <source>Give at least {v1} with different robot poses, and turn the table by 60° or more.</source>
      <translation>请至少给出 {v1} 个，机器人位姿不同，转台转动 60° 以上。</translation>
    </message>
    <message>
      <source>Give base_from_flange for the robot and camera_from_board for the board.</source>
      <translation>请给出机器人的 base_from_flange 和标定板的 camera_from_board。</translation>
    </message>
    <message>
      <source>Give columns and rows of the projector.</source>
      <translation>请给出投影仪的列数和行数。</translation>
    </message>
    <message>
      <source>Give guide positions in mm.</source>
      <translation>请以 mm 给出导轨位置。</translation>
    </message>
    <message>
      <source>Give images of calibrated cameras.</source>
      <translation>请给出已标定相机的图像。</translation>
    </message>
    <message>
      <source>Give one angle per position.</source>
      <translation>请每个位置给出一个角度。</translation>
    </message>
    <message>
      <source>Give one image per camera with every observation.</source>
      <translation>请每次观测每台相机给出一幅图像。</translation>
    </message>
    <message>
      <source>Give one of each per position.</source>
      <translation>请每个位置各给出一个。</translation>
    </message>
    <message>
      <source>Give poses the robot can reach and from which the board is visible.</source>
      <translation>请给出机器人可达且能看到标定板的位姿。</translation>
    </message>
    <message>
      <source>Give the camera Jacobian of every board pose, or no camera prior.</source>
      <translation>请给出每个标定板位姿的相机雅可比，或不给相机先验。</translation>
    </message>
    <message>
      <source>Give the camera another name.</source>
      <translation>请给相机起另一个名称。</translation>
    </message>
    <message>
      <source>Give the distance at which parts are measured.</source>
      <translation>请给出测量工件的距离。</translation>
    </message>
    <message>
      <source>Give the images of all cameras in the same order, one of each camera per board position.</source>
      <translation>请以相同顺序给出所有相机的图像，每个标定板位置每台相机一幅。</translation>
    </message>
    <message>
      <source>Give the size of the board that was used, or use the {v1}.</source>
      <translation>请给出所用标定板的尺寸，或使用{v1}。</translation>
    </message>
    <message>
      <source>Give the size of the board that was used.</source>
      <translation>请给出所用标定板的尺寸。</translation>
    </message>
    <message>
      <source>Hand–eye, guide and table axis were determined with the earlier cameras: calibrate the rig next.</source>
      <translation>手眼、导轨和转台轴线是用先前的相机确定的：接下来请标定测量系统。</translation>
    </message>
    <message>
      <source>Hold the board {v1}</source>
      <translation>请将标定板{v1}</translation>
    </message>
    <message>
      <source>Image centre x</source>
      <translation>图像中心 x</translation>
    </message>
    <message>
      <source>Image centre y</source>
      <translation>图像中心 y</translation>
    </message>
    <message>
      <source>It was {v1} °C at the head and {v2} °C at the calibration ({v3} K are allowed), which may cost {v4}: let the head come to its temperature, or check the calibration with a few views of the board.</source>
      <translation>测头温度为 {v1} °C，标定时为 {v2} °C（允许 {v3} K），可能造成 {v4} 的误差：请待测头达到其温度，或用几个标定板视图检查标定。</translation>
    </message>
    <message>
      <source>Keep the robot still while the guide moves: the errors of its poses would count as errors of the guide</source>
      <translation>导轨移动时请保持机器人静止：其位姿误差会算作导轨误差</translation>
    </message>
    <message>
      <source>Lengthen the exposure or add light until the board's white reaches half of full scale.</source>
      <translation>请延长曝光或增加光照，直到标定板的白色达到满量程的一半。</translation>
    </message>
    <message>
      <source>Lens and pose of the projector, relative to calibrated cameras</source>
      <translation>投影仪相对于已标定相机的镜头和位姿</translation>
    </message>
    <message>
      <source>More observations alone will not make it good: sharper images, a larger board, or larger differences between positions are needed.</source>
      <translation>仅增加观测不会使其良好：需要更清晰的图像、更大的标定板或更大的位置差异。</translation>
    </message>
    <message>
      <source>More views for the projector alone will not make it good: {added} of it come from the calibration of the cameras. Calibrate the cameras from more views first.</source>
      <translation>仅增加投影仪视图不会使其良好：其中 {added} 来自相机标定。请先用更多视图标定相机。</translation>
    </message>
    <message>
      <source>Move the guide as far as the board stays in view: a longer travel determines its direction better.</source>
      <translation>在标定板保持可见的范围内尽量移动导轨：行程越长，方向确定得越好。</translation>
    </message>
    <message>
      <source>Move the guide further</source>
      <translation>请将导轨移得更远</translation>
    </message>
    <message>
      <source>Moves a point by {v1} (k = 2) between views {v2} mm of the guide apart</source>
      <translation>导轨上相距 {v2} mm 的视图之间，使点移动 {v1} (k = 2)</translation>
    </message>
    <message>
      <source>Moves a point {v1} mm from the axis by {v2} (k = 2) between views half a turn apart</source>
      <translation>相差半圈的视图之间，使距轴线 {v1} mm 的点移动 {v2} (k = 2)</translation>
    </message>
    <message>
      <source>Moves {v1} by up to {v2} (k = 2) across its line of sight</source>
      <translation>使{v1}在垂直于视线方向上最多移动 {v2} (k = 2)</translation>
    </message>
    <message>
      <source>Name a result of the same kind of calibration.</source>
      <translation>请指定同类标定的结果。</translation>
    </message>
    <message>
      <source>Name one of the cameras given.</source>
      <translation>请指定所给相机之一。</translation>
    </message>
    <message>
      <source>Name the cameras once each, the reference first.</source>
      <translation>请每台相机列出一次，参考相机在前。</translation>
    </message>
    <message>
      <source>Neither the board nor the robot's arm moves; only the guide does.</source>
      <translation>标定板和机器人手臂都不动；只有导轨移动。</translation>
    </message>
    <message>
      <source>No camera saw the board.</source>
      <translation>没有相机看到标定板。</translation>
    </message>
    <message>
      <source>No observation shows the {v1} yet.</source>
      <translation>还没有观测显示{v1}。</translation>
    </message>
    <message>
      <source>No pose of the robot is further than {v1} mm from its base.</source>
      <translation>没有机器人位姿距其基座超过 {v1} mm。</translation>
    </message>
    <message>
      <source>Not observable: {v1}.</source>
      <translation>无法观测：{v1}。</translation>
    </message>
    <message>
      <source>Nothing may move while the fringes of one view are taken. White should be bright, but not clipped.</source>
      <translation>拍摄一个视图的条纹时不得有任何移动。白色应明亮，但不过饱和。</translation>
    </message>
    <message>
      <source>Observations changed since it was solved: solve again.</source>
      <translation>求解之后观测已更改：请重新求解。</translation>
    </message>
    <message>
      <source>One of the cameras {v1}</source>
      <translation>相机 {v1} 之一</translation>
    </message>
    <message>
      <source>Only {v1} corners of the {v2} can be seen; at least {v3} are needed.</source>
      <translation>只能看到{v2}的 {v1} 个角点；至少需要 {v3} 个。</translation>
    </message>
    <message>
      <source>Only {v1} of the {v2} marks of the {v3} can be seen, and they may be any of {v4} parts of it.</source>
      <translation>只能看到{v3}的 {v2} 个标记中的 {v1} 个，它们可能是其 {v4} 个部分中的任一个。</translation>
    </message>
    <message>
      <source>Only {v1} of the {v2} marks of the {v3} can be seen.</source>
      <translation>只能看到 {v3} 的 {v2} 个标记中的 {v1} 个。</translation>
    </message>
    <message>
      <source>Only {v1} points of the working volume {v2} mm in front of the cameras are seen by two of them.</source>
      <translation>相机前 {v2} mm 的工作空间中只有 {v1} 个点被两台相机看到。</translation>
    </message>
    <message>
      <source>Pitch, yaw or roll of the guide</source>
      <translation>导轨的俯仰、偏摆或滚转</translation>
    </message>
    <message>
      <source>Places a point {v1} mm in front of the cameras to {v2} (k = 2) relative to the flange</source>
      <translation>将相机前方 {v1} mm 处的点相对法兰定位到 {v2} (k = 2)</translation>
    </message>
    <message>
      <source>Pose of the head on the robot's flange</source>
      <translation>测头在机器人法兰上的位姿</translation>
    </message>
    <message>
      <source>Position and direction of the rotary table's axis</source>
      <translation>转台轴线的位置和方向</translation>
    </message>
    <message>
      <source>Position {v1} turned by {v2}° against the first, but its angle says {v3}°.</source>
      <translation>位置 {v1} 相对第一个转动了 {v2}°，但其角度为 {v3}°。</translation>
    </message>
    <message>
      <source>Recorded fringes</source>
      <translation>录制的条纹</translation>
    </message>
    <message>
      <source>Recorded images</source>
      <translation>录制的图像</translation>
    </message>
    <message>
      <source>Roll the camera about its line of sight: it was rolled by only</source>
      <translation>请绕光轴滚转相机：它只滚转了</translation>
    </message>
    <message>
      <source>Rotation</source>
      <translation>旋转</translation>
    </message>
    <message>
      <source>Scale</source>
      <translation>比例</translation>
    </message>
    <message>
      <source>Set the board up steeply on the table, so that its corners lie at different heights, and turn the table further.</source>
      <translation>请将标定板陡立在转台上，使其角点处于不同高度，并进一步转动转台。</translation>
    </message>
    <message>
      <source>Shorten the exposure or dim the light until the board's white is no longer clipped.</source>
      <translation>请缩短曝光或调暗光照，直到标定板的白色不再过饱和。</translation>
    </message>
    <message>
      <source>Show it nearer and farther, sharp, evenly lit and not so bright that its white is clipped.</source>
      <translation>请在更近和更远处显示，清晰、照明均匀，且白色不过亮。</translation>
    </message>
    <message>
      <source>Show more of the board.</source>
      <translation>请显示更多标定板。</translation>
    </message>
    <message>
      <source>Show one whole side of the board with the white margin at both of its ends, or use a ChArUco board, of which any part is enough.</source>
      <translation>请显示标定板完整的一条边及其两端的白边，或使用 ChArUco 标定板，其任一部分即可。</translation>
    </message>
    <message>
      <source>Show the board</source>
      <translation>显示标定板</translation>
    </message>
    <message>
      <source>Show the board in {v1} more {v2}, sharp and whole</source>
      <translation>请再在 {v1} 个{v2}展示标定板，要清晰且完整</translation>
    </message>
    <message>
      <source>Show the board where cameras {v1} and {v2} both see it, {v3}</source>
      <translation>在相机 {v1} 和 {v2} 都能看到的地方展示标定板，{v3}</translation>
    </message>
    <message>
      <source>Show the board {v1} of {v2}</source>
      <translation>请{v1}展示标定板（{v2}）</translation>
    </message>
    <message>
      <source>Show the fixed board from the first robot pose</source>
      <translation>从第一个机器人位姿显示固定的标定板</translation>
    </message>
    <message>
      <source>Show the whole board, evenly lit.</source>
      <translation>请显示整块标定板，照明均匀。</translation>
    </message>
    <message>
      <source>Show the whole board, or use a ChArUco board, of which a part is enough.</source>
      <translation>请显示整个标定板，或使用 ChArUco 标定板，其一部分即可。</translation>
    </message>
    <message>
      <source>Solve again.</source>
      <translation>请重新求解。</translation>
    </message>
    <message>
      <source>Solve what was collected first.</source>
      <translation>请先求解已采集的内容。</translation>
    </message>
    <message>
      <source>Spread of distances</source>
      <translation>距离的分布</translation>
    </message>
    <message>
      <source>Start without calibrated cameras; compare with them later.</source>
      <translation>请不用已标定相机开始；稍后再比较。</translation>
    </message>
    <message>
      <source>Sweep of the table</source>
      <translation>转台的扫过角度</translation>
    </message>
    <message>
      <source>Switch mirroring off in the camera's settings.</source>
      <translation>请在相机设置中关闭镜像。</translation>
    </message>
    <message>
      <source>Table positions</source>
      <translation>转台位置</translation>
    </message>
    <message>
      <source>Take a board with {v1}.</source>
      <translation>请使用有 {v1} 的标定板。</translation>
    </message>
    <message>
      <source>Take a pose in which the board's {v1} is farther from the {v2}, the board tilted by 20° to 45°</source>
      <translation>取一个位姿，使标定板的{v1}离{v2}更远，标定板倾斜 20° 至 45°</translation>
    </message>
    <message>
      <source>Take a sharper and brighter image of the flat board.</source>
      <translation>请为平整的标定板拍摄更清晰、更明亮的图像。</translation>
    </message>
    <message>
      <source>Take a sharper image, or move closer so that the squares appear larger.</source>
      <translation>请拍摄更清晰的图像，或靠近使方格更大。</translation>
    </message>
    <message>
      <source>Take poses {v1}</source>
      <translation>请取位姿：{v1}</translation>
    </message>
    <message>
      <source>Take ten poses or more: the robot's own errors average out.</source>
      <translation>请拍摄十个以上位姿：机器人自身误差会被平均。</translation>
    </message>
    <message>
      <source>Take ten views or more.</source>
      <translation>请拍摄十个以上视图。</translation>
    </message>
    <message>
      <source>Take the board at {count} more table {positions}, between those there are</source>
      <translation>请再在 {count} 个转台{positions}拍摄标定板，取在已有位置之间</translation>
    </message>
    <message>
      <source>Take the board at {v1} more table positions, each turned by 15° to 30°</source>
      <translation>再在 {v1} 个转台位置拍摄标定板，每次转动 15° 至 30°</translation>
    </message>
    <message>
      <source>Take the board from {count} more guide {positions}, between those there are</source>
      <translation>请再从 {count} 个导轨{positions}拍摄标定板，取在已有位置之间</translation>
    </message>
    <message>
      <source>Take the fixed board from {v1} positions of the guide or more, {v2} mm apart</source>
      <translation>在导轨的 {v1} 个或更多位置拍摄固定的标定板，间隔 {v2} mm</translation>
    </message>
    <message>
      <source>Take the views</source>
      <translation>拍摄视图</translation>
    </message>
    <message>
      <source>Take {v1} another tilt and place, to average the noise</source>
      <translation>再拍{v1}不同的倾斜和位置，以平均噪声</translation>
    </message>
    <message>
      <source>Take {v1} more robot {v2}: more average the robot's own errors</source>
      <translation>再取 {v1} 个机器人{v2}：数量更多可平均机器人自身的误差</translation>
    </message>
    <message>
      <source>The arcs span only {v1}°, which makes their centres uncertain: turn the table further.</source>
      <translation>圆弧仅跨 {v1}°，其圆心因此不确定：请让转台转得更远。</translation>
    </message>
    <message>
      <source>The board is blurred: its edges are {v1} px wide, {v2} px is the most.</source>
      <translation>标定板模糊：其边缘宽 {v1} px，最多允许 {v2} px。</translation>
    </message>
    <message>
      <source>The board is over-exposed: its white is clipped at {v1} of the marks, which makes them scatter.</source>
      <translation>标定板过曝：{v1} 的标记处白色过饱和，使标记离散。</translation>
    </message>
    <message>
      <source>The board is too dark: its white is {v1} of 255.</source>
      <translation>标定板太暗：其白色为 255 中的 {v1}。</translation>
    </message>
    <message>
      <source>The board lies behind the camera: the board poses seem to be board_from_camera.</source>
      <translation>标定板位于相机后方：标定板位姿似乎是 board_from_camera。</translation>
    </message>
    <message>
      <source>The board moved {v1} times as far as the robot.</source>
      <translation>标定板移动的距离是机器人的 {v1} 倍。</translation>
    </message>
    <message>
      <source>The board must not move between the views.</source>
      <translation>视图之间标定板不得移动。</translation>
    </message>
    <message>
      <source>The board poses put the board {v1} mm from the camera.</source>
      <translation>标定板位姿使其距相机 {v1} mm。</translation>
    </message>
    <message>
      <source>The board seems to turn by up to {v1}°: it moved, or the hand-eye transform is wrong. Take the positions again.</source>
      <translation>标定板似乎转动了多达 {v1}°：它移动了，或手眼变换有误。请重新采集这些位置。</translation>
    </message>
    <message>
      <source>The board turned by only {v1}° in all.</source>
      <translation>标定板总共只转动了 {v1}°。</translation>
    </message>
    <message>
      <source>The calibration does not belong to these cameras: {v1}.</source>
      <translation>该标定不属于这些相机：{v1}。</translation>
    </message>
    <message>
      <source>The calibration is dated {v1}, which is in the future: check the computer's clock.</source>
      <translation>标定日期 {v1} 在未来：请检查计算机的时钟。</translation>
    </message>
    <message>
      <source>The calibration of {v1} was valid for {v2} days and has expired; only images of the board show what that means in mm: check it with a few views of the board, or calibrate again.</source>
      <translation>{v1} 的标定有效期为 {v2} 天，现已过期；只有标定板图像才能显示这相当于多少毫米：请用几个标定板视图检查，或重新标定。</translation>
    </message>
    <message>
      <source>The cameras are what is to be calibrated.</source>
      <translation>要标定的正是相机。</translation>
    </message>
    <message>
      <source>The centres of the corners' arcs do not form a line (they spread {v1} times as far along the axis as across it; {v2} are needed).</source>
      <translation>角点圆弧的中心不成一线（沿轴分布为横向的 {v1} 倍；需要 {v2} 倍）。</translation>
    </message>
    <message>
      <source>The contribution of robot and hand–eye does not shrink with more observations. Calibrate the whole rig, which averages over many robot poses, or let registration correct it.</source>
      <translation>机器人和手眼的贡献不随观测增多而减小。请标定整个测量系统，它对许多机器人位姿取平均，或由配准修正。</translation>
    </message>
    <message>
      <source>The corners of the board cannot be refined.</source>
      <translation>无法细化标定板的角点。</translation>
    </message>
    <message>
      <source>The date of the calibration, {v1}, cannot be read, so that it counts as expired.</source>
      <translation>无法读取标定日期 {v1}，因此视为已过期。</translation>
    </message>
    <message>
      <source>The derivatives of the board poses with respect to the cameras are missing.</source>
      <translation>缺少标定板位姿对相机的导数。</translation>
    </message>
    <message>
      <source>The given cameras have {v1} distortion coefficients, at most {v2} are offered.</source>
      <translation>所给相机有 {v1} 个畸变系数，最多提供 {v2} 个。</translation>
    </message>
    <message>
      <source>The guide runs {v1}° away from every axis of the robot's base: check that the robot poses are base_from_flange, not flange_from_base, and that the hand-eye transform is the one of these cameras.</source>
      <translation>导轨方向与机器人基座的各轴都相差 {v1}°：请检查机器人位姿是 base_from_flange 而不是 flange_from_base，且手眼变换属于这些相机。</translation>
    </message>
    <message>
      <source>The guide travelled {v1} mm, but the board moved 1000 times as far.</source>
      <translation>导轨移动了 {v1} mm，但标定板移动了 1000 倍。</translation>
    </message>
    <message>
      <source>The guide's straightness error</source>
      <translation>导轨的直线度误差</translation>
    </message>
    <message>
      <source>The image shows {v1} markers that a {v2} does not have (its own are 0 to {v3}).</source>
      <translation>图像中有 {v1} 个{v2}所没有的标记（其自身的标记为 0 至 {v3}）。</translation>
    </message>
    <message>
      <source>The images contradict the calibration of the cameras by {rms:.1f} px in most observations.</source>
      <translation>在多数观测中，图像与相机标定相差 {rms:.1f} px。</translation>
    </message>
    <message>
      <source>The images of camera {v1} are {v2} × {v3} px, it was calibrated for {v4} × {v5} px.</source>
      <translation>相机 {v1} 的图像为 {v2} × {v3} px，而标定时为 {v4} × {v5} px。</translation>
    </message>
    <message>
      <source>The images of cameras {v1} and {v2} do not belong together: in {v3} of {v4} views they show different board positions.</source>
      <translation>相机 {v1} 与 {v2} 的图像不匹配：{v4} 个视图中有 {v3} 个显示不同的标定板位置。</translation>
    </message>
    <message>
      <source>The images of this scan cannot show whether the cameras moved; check them with a few views of the board.</source>
      <translation>此次扫描的图像无法显示相机是否移动；请用几个标定板视图检查。</translation>
    </message>
    <message>
      <source>The marks in the image do not lie as on a {v1}.</source>
      <translation>图像中标记的排列与{v1}不符。</translation>
    </message>
    <message>
      <source>The marks of the board are displaced by {v1} (rms){v2}, the one in row {v3}, column {v4} by {v5}: their places were estimated with the cameras. Have the board certified, or use a better one.</source>
      <translation>标定板的标志点偏离其位置 {v1}（均方根）{v2}，第 {v3} 行第 {v4} 列的标志点偏离 {v5}：它们的位置已与相机一同估计。请对标定板进行检定，或使用更好的标定板。</translation>
    </message>
    <message>
      <source>The marks of the board that are visible are too few, or lie on one line.</source>
      <translation>可见的标定板标记太少，或位于一条直线上。</translation>
    </message>
    <message>
      <source>The marks scatter by {v1} px about a smooth grid, {v2} px is the most.</source>
      <translation>标记相对平滑网格离散 {v1} px，最多允许 {v2} px。</translation>
    </message>
    <message>
      <source>The motions are {v1}.</source>
      <translation>运动为 {v1}。</translation>
    </message>
    <message>
      <source>The motions do not determine the rotation.</source>
      <translation>这些运动不能确定旋转。</translation>
    </message>
    <message>
      <source>The new calibration moves {v1} by {v2}</source>
      <translation>新标定使{v1}移动 {v2}</translation>
    </message>
    <message>
      <source>The observations do not determine the rig: {v1}.</source>
      <translation>这些观测不能确定测量系统：{v1}。</translation>
    </message>
    <message>
      <source>The observations leave a parameter undetermined.</source>
      <translation>这些观测使某参数无法确定。</translation>
    </message>
    <message>
      <source>The observations of the solution are no longer there.</source>
      <translation>解的观测已不存在。</translation>
    </message>
    <message>
      <source>The pose of the board in observation {v1} is not known.</source>
      <translation>观测 {v1} 中标定板的位姿未知。</translation>
    </message>
    <message>
      <source>The poses do not determine the hand-eye transform.</source>
      <translation>这些位姿不能确定手眼变换。</translation>
    </message>
    <message>
      <source>The poses do not determine the rotation.</source>
      <translation>这些位姿不能确定旋转。</translation>
    </message>
    <message>
      <source>The poses turn the camera by at most {v1}° against each other, or by nearly half a turn.</source>
      <translation>各位姿使相机相互间最多转动 {v1}°，或接近半圈。</translation>
    </message>
    <message>
      <source>The poses turn the camera by at most {v1}° against each other.</source>
      <translation>各位姿使相机相互间最多转动 {v1}°。</translation>
    </message>
    <message>
      <source>The positions contradict each other by {v1} mm, {v2} times the noise of the images: the board moved on the table, or the table wobbles. Fix the board and take the positions again; with five or more the one that moved is found.</source>
      <translation>各位置相互矛盾 {v1} mm，为图像噪声的 {v2} 倍：标定板在转台上移动了，或转台晃动。请固定标定板并重新采集；有五个或更多位置时可找出移动的那一个。</translation>
    </message>
    <message>
      <source>The positions lie {v1} mm off an even, straight travel: fix the board and take them again, or check the guide.</source>
      <translation>各位置偏离均匀直线行程 {v1} mm：请固定标定板并重新采集，或检查导轨。</translation>
    </message>
    <message>
      <source>The positions of a corner lie on a line, not on an arc.</source>
      <translation>角点的位置成直线，而非圆弧。</translation>
    </message>
    <message>
      <source>The positions span only {v1} mm: spread them over more of the stroke.</source>
      <translation>各位置仅跨 {v1} mm：请让它们分布到更长的行程上。</translation>
    </message>
    <message>
      <source>The positions span {v1} mm; {v2} mm or more give a better direction.</source>
      <translation>各位置跨 {v1} mm；{v2} mm 或更长可得到更好的方向。</translation>
    </message>
    <message>
      <source>The previous axis is given in frame {v1}, the new one in {v2}.</source>
      <translation>先前的轴线以坐标系 {v1} 给出，新的以 {v2} 给出。</translation>
    </message>
    <message>
      <source>The previous calibration is not one of {v1}.</source>
      <translation>先前的标定不是 {v1} 的。</translation>
    </message>
    <message>
      <source>The previous calibration is one of {v1} with {v2} as reference, the new one of {v3} with {v4}.</source>
      <translation>先前的标定属于 {v1}，以 {v2} 为参考，新的属于 {v3}，以 {v4} 为参考。</translation>
    </message>
    <message>
      <source>The projector is not calibrated.</source>
      <translation>投影仪未标定。</translation>
    </message>
    <message>
      <source>The projector was calibrated with the earlier cameras: calibrate it again.</source>
      <translation>投影仪是用先前的相机标定的：请重新标定。</translation>
    </message>
    <message>
      <source>The reference camera {v1} has no images.</source>
      <translation>参考相机 {v1} 没有图像。</translation>
    </message>
    <message>
      <source>The residuals are {v1} times as large as expected: the board moved, the robot is less accurate than stated, or robot poses belong to other images. Check that the board is fixed, state the robot's errors, or take the poses again.</source>
      <translation>残差是预期的 {v1} 倍：标定板移动了、机器人不如所述准确，或机器人位姿与图像不对应。请检查标定板是否固定，给出机器人的误差，或重新采集位姿。</translation>
    </message>
    <message>
      <source>The residuals are {v1} times as large as expected: the robot is less accurate than stated, the board moved, or tables and images do not belong together.</source>
      <translation>残差是预期的 {v1} 倍：机器人不如所述准确、标定板移动了，或表格与图像不对应。</translation>
    </message>
    <message>
      <source>The rest of the rig is not calibrated yet.</source>
      <translation>测量系统其余部分尚未标定。</translation>
    </message>
    <message>
      <source>The robot moved {v1} mm per displayed millimetre of the guide.</source>
      <translation>导轨每显示一毫米，机器人移动 {v1} mm。</translation>
    </message>
    <message>
      <source>The robot moved {v1} mm per displayed millimetre of the guide: check the stated size of the board's squares.</source>
      <translation>导轨每显示一毫米，机器人移动 {v1} mm：请检查所述的标定板方格尺寸。</translation>
    </message>
    <message>
      <source>The robot poses seem to be flange_from_base (or the board poses board_from_camera).</source>
      <translation>机器人位姿似乎是 flange_from_base（或标定板位姿为 board_from_camera）。</translation>
    </message>
    <message>
      <source>The robot poses seem to be in metres: give mm.</source>
      <translation>机器人位姿似乎以米为单位：请给出 mm。</translation>
    </message>
    <message>
      <source>The size of the projector's image is not known.</source>
      <translation>投影仪图像的尺寸未知。</translation>
    </message>
    <message>
      <source>The squares of the board are not plain: markers are printed in them.</source>
      <translation>标定板的方格不是纯色：其中印有标记。</translation>
    </message>
    <message>
      <source>The stated uncertainty can be trusted: {v1}; {v2}.</source>
      <translation>所述不确定度可信：{v1}；{v2}。</translation>
    </message>
    <message>
      <source>The stated uncertainty is too small, there are errors other than noise: {v1}; {v2}. Try 8 distortion coefficients, check the board for flatness and the images for blur.</source>
      <translation>所述不确定度过小，存在噪声以外的误差：{v1}；{v2}。请尝试 8 个畸变系数，检查标定板的平面度和图像的模糊。</translation>
    </message>
    <message>
      <source>The table turned by {v1}°; turn it by 30° or more.</source>
      <translation>转台转动了 {v1}°；请转动 30° 或更多。</translation>
    </message>
    <message>
      <source>The table's axial error motion</source>
      <translation>转台的轴向误差运动</translation>
    </message>
    <message>
      <source>The table's radial error motion</source>
      <translation>转台的径向误差运动</translation>
    </message>
    <message>
      <source>The table's tilt error motion</source>
      <translation>转台的倾斜误差运动</translation>
    </message>
    <message>
      <source>The translations of the {v1} poses are about {v2} times too small for those of the others.</source>
      <translation>{v1} 位姿的平移约比其他的小 {v2} 倍。</translation>
    </message>
    <message>
      <source>The uncertainty of the cameras themselves is not known: it comes in addition.</source>
      <translation>相机自身的不确定度未知：须另外计入。</translation>
    </message>
    <message>
      <source>The views of camera {v1} do not determine its focal length ({v2} ± {v3} px).</source>
      <translation>相机 {v1} 的视图不能确定其焦距（{v2} ± {v3} px）。</translation>
    </message>
    <message>
      <source>The views of camera {v1} do not determine its lens.</source>
      <translation>相机 {v1} 的视图不能确定其镜头。</translation>
    </message>
    <message>
      <source>The whole board must be visible, sharp and not over-exposed; check the kind of board and its size.</source>
      <translation>整个标定板必须可见、清晰且不过曝；请检查标定板的类型和尺寸。</translation>
    </message>
    <message>
      <source>The {v1} poses seem to be in metres: give mm.</source>
      <translation>{v1} 位姿似乎以米为单位：请给出 mm。</translation>
    </message>
    <message>
      <source>The {v1} was not detected yet.</source>
      <translation>尚未检测到 {v1}。</translation>
    </message>
    <message>
      <source>The {v1} was not found.</source>
      <translation>未找到{v1}。</translation>
    </message>
    <message>
      <source>The {v1} was not found: its markers are there, but not placed as on this board.</source>
      <translation>未找到{v1}：有其标记，但排列与此标定板不符。</translation>
    </message>
    <message>
      <source>The {v1} was not found: nothing in the image is sharp, it is blurred.</source>
      <translation>未找到{v1}：图像中没有清晰之处，图像模糊。</translation>
    </message>
    <message>
      <source>The {v1} was not found: only {v2} of its {v3} marks can be seen, the rest is hidden or outside the image.</source>
      <translation>未找到{v1}：只能看到其 {v3} 个标记中的 {v2} 个，其余被遮挡或在图像之外。</translation>
    </message>
    <message>
      <source>The {v1} was not found: the board in the image looks like one of {v2}.</source>
      <translation>未找到{v1}：图像中的标定板看起来是 {v2} 的。</translation>
    </message>
    <message>
      <source>The {v1} was not found: the image is mirrored.</source>
      <translation>未找到{v1}：图像是镜像的。</translation>
    </message>
    <message>
      <source>The {v1} was not found: the image is over-exposed ({v2} clipped).</source>
      <translation>未找到{v1}：图像过曝（{v2} 过饱和）。</translation>
    </message>
    <message>
      <source>The {v1} was not found: the image is too dark ({v2} of 255).</source>
      <translation>未找到{v1}：图像太暗（255 中的 {v2}）。</translation>
    </message>
    <message>
      <source>There are no candidate poses.</source>
      <translation>没有候选位姿。</translation>
    </message>
    <message>
      <source>There are: </source>
      <translation>有：</translation>
    </message>
    <message>
      <source>There are: {v1}.</source>
      <translation>有：{v1}。</translation>
    </message>
    <message>
      <source>There is no solution yet.</source>
      <translation>尚无解。</translation>
    </message>
    <message>
      <source>They seem to be in metres: give mm.</source>
      <translation>它们似乎以米为单位：请给出 mm。</translation>
    </message>
    <message>
      <source>This scan would not show {v1}; a few views of the board would.</source>
      <translation>本次扫描无法发现：{v1}；几个标定板视图则可以。</translation>
    </message>
    <message>
      <source>This scan would not show {v1}; fringes of both directions, or a few views of the board, would.</source>
      <translation>本次扫描无法发现：{v1}；两个方向的条纹或几个标定板视图则可以。</translation>
    </message>
    <message>
      <source>Tilt it by 20° to 45° to all four sides, and show it nearer and farther.</source>
      <translation>请向四个方向倾斜 20° 至 45°，并在更近和更远处显示。</translation>
    </message>
    <message>
      <source>Tilt the board by 20° to 45° in several directions.</source>
      <translation>请向多个方向将标定板倾斜 20° 至 45°。</translation>
    </message>
    <message>
      <source>Tilt the board by 20° to 45° to all four sides: this separates the focal length from the distance.</source>
      <translation>请向四个方向将标定板倾斜 20° 至 45°：这可区分焦距与距离。</translation>
    </message>
    <message>
      <source>Tilt the board in several directions and fill the image.</source>
      <translation>请向多个方向倾斜标定板并充满图像。</translation>
    </message>
    <message>
      <source>Tilt the board in several directions.</source>
      <translation>请向多个方向倾斜标定板。</translation>
    </message>
    <message>
      <source>Tilt the board more {v1} (its {v2} away from the {v3}), by 20° to 45°</source>
      <translation>请使标定板更多地{v1}倾斜（其{v2}远离{v3}），20° 至 45°</translation>
    </message>
    <message>
      <source>Tilt, all directions</source>
      <translation>倾斜，所有方向</translation>
    </message>
    <message>
      <source>To calibrate the linear guide, the hand-eye transform is needed.</source>
      <translation>标定直线导轨需要手眼变换。</translation>
    </message>
    <message>
      <source>To calibrate {v1}, calibrated cameras are needed.</source>
      <translation>标定{v1}需要已标定的相机。</translation>
    </message>
    <message>
      <source>Too many observations of the board contradict each other: {v1}.</source>
      <translation>过多的标定板观测相互矛盾：{v1}。</translation>
    </message>
    <message>
      <source>Travel of the guide</source>
      <translation>导轨行程</translation>
    </message>
    <message>
      <source>Turn the head about all three axes: up and down, sideways, and about its line of sight.</source>
      <translation>请绕三个轴转动测头：上下、左右和绕其光轴。</translation>
    </message>
    <message>
      <source>Turn the table as far as the board stays in view: short arcs leave their centre uncertain.</source>
      <translation>在标定板保持可见的范围内尽量转动转台：短弧使其中心不确定。</translation>
    </message>
    <message>
      <source>Turn the table further</source>
      <translation>请进一步转动转台</translation>
    </message>
    <message>
      <source>Turn the table further between the positions.</source>
      <translation>请在位置之间更多地转动转台。</translation>
    </message>
    <message>
      <source>Turn the table further, best by 60° or more.</source>
      <translation>请进一步转动转台，最好 60° 以上。</translation>
    </message>
    <message>
      <source>Turns about the line of sight</source>
      <translation>绕光轴转动</translation>
    </message>
    <message>
      <source>Turns left and right</source>
      <translation>左右转动</translation>
    </message>
    <message>
      <source>Turns up and down</source>
      <translation>上下转动</translation>
    </message>
    <message>
      <source>Up to {v1} mm is good, up to {v2} mm usable: {v3}.</source>
      <translation>{v1} mm 以内良好，{v2} mm 以内可用：{v3}。</translation>
    </message>
    <message>
      <source>Use the calibration of the cameras that took the images.</source>
      <translation>请使用拍摄这些图像的相机的标定。</translation>
    </message>
    <message>
      <source>Use the calibration of the cameras that took the images: {v1}.</source>
      <translation>请使用拍摄这些图像的相机的标定：{v1}。</translation>
    </message>
    <message>
      <source>View the board from higher up and from lower down: the camera was tilted up and down by only</source>
      <translation>请从更高和更低处观察标定板：相机上下只倾斜了</translation>
    </message>
    <message>
      <source>View the board more from the left and from the right: the camera was swung sideways by only</source>
      <translation>请更多地从左侧和右侧观察标定板：相机左右只摆动了</translation>
    </message>
    <message>
      <source>Views of one part fit together to {v1} (k = 2), at worst {v2}, before registration</source>
      <translation>配准之前，同一工件的视图彼此吻合到 {v1} (k = 2)，最差 {v2}</translation>
    </message>
    <message>
      <source>Views shared by {v1} and {v2}</source>
      <translation>{v1} 与 {v2} 共有的视图</translation>
    </message>
    <message>
      <source>Whole rig</source>
      <translation>整个测量系统</translation>
    </message>
    <message>
      <source>a calibration of several cameras</source>
      <translation>多台相机的标定</translation>
    </message>
    <message>
      <source>a camera</source>
      <translation>一台相机</translation>
    </message>
    <message>
      <source>a pitch of {camera} below {limit}°</source>
      <translation>{camera} 小于 {limit}° 的俯仰</translation>
    </message>
    <message>
      <source>a point {v1} mm from the axis, between views half a turn apart,</source>
      <translation>距轴线 {v1} mm 的点（相差半圈的视图之间）</translation>
    </message>
    <message>
      <source>a point {v1} mm in front of the camera</source>
      <translation>相机前方 {v1} mm 处的点</translation>
    </message>
    <message>
      <source>a point {v1} mm in front of the cameras</source>
      <translation>各相机前方 {v1} mm 处的点</translation>
    </message>
    <message>
      <source>a point, between views {v1} mm of the guide apart,</source>
      <translation>点（导轨上相距 {v1} mm 的视图之间）</translation>
    </message>
    <message>
      <source>a roll of {camera} below {limit}°</source>
      <translation>{camera} 小于 {limit}° 的滚转</translation>
    </message>
    <message>
      <source>a yaw of {camera} below {limit}°</source>
      <translation>{camera} 小于 {limit}° 的偏摆</translation>
    </message>
    <message>
      <source>an even and an odd number of corners, such as 14 × 11 or 9 × 6, or a ChArUco board</source>
      <translation>行列角点数一偶一奇，如 14 × 11 或 9 × 6，或使用 ChArUco 板</translation>
    </message>
    <message>
      <source>an odd number of rows, such as 4 × 11</source>
      <translation>奇数行，如 4 × 11</translation>
    </message>
    <message>
      <source>axis direction</source>
      <translation>轴线方向</translation>
    </message>
    <message>
      <source>axis point</source>
      <translation>轴线上的点</translation>
    </message>
    <message>
      <source>axis, across</source>
      <translation>轴线，横向</translation>
    </message>
    <message>
      <source>bundle: </source>
      <translation>光束法平差：</translation>
    </message>
    <message>
      <source>camera on the flange, place</source>
      <translation>法兰上的相机，位置</translation>
    </message>
    <message>
      <source>camera on the flange, rotation</source>
      <translation>法兰上的相机，旋转</translation>
    </message>
    <message>
      <source>camera {v1} gives {v2} × {v3} px, {v4} × {v5} px were calibrated</source>
      <translation>相机 {v1} 给出 {v2} × {v3} px，标定时为 {v4} × {v5} px</translation>
    </message>
    <message>
      <source>camera {v1} has serial number {v2}{v3}, {v4} was calibrated</source>
      <translation>相机 {v1} 的序列号为 {v2}{v3}，标定的是 {v4}</translation>
    </message>
    <message>
      <source>camera {v1} is set to {v2} {v3}, {v4} was calibrated</source>
      <translation>相机 {v1} 的{v2}设为 {v3}，标定时为 {v4}</translation>
    </message>
    <message>
      <source>cameras {v1} show different board positions: the board moved, or images were exchanged</source>
      <translation>相机 {v1} 显示的标定板位置不同：标定板移动了，或图像互换了</translation>
    </message>
    <message>
      <source>check the calibration with a few views of the board before the next measurement that matters.</source>
      <translation>在下一次重要测量之前，请用几个标定板视图检查标定。</translation>
    </message>
    <message>
      <source>direction of the guide, first tilt</source>
      <translation>导轨方向，第一倾角</translation>
    </message>
    <message>
      <source>direction of the guide, second tilt</source>
      <translation>导轨方向，第二倾角</translation>
    </message>
    <message>
      <source>direction of the rotation axis, first tilt</source>
      <translation>旋转轴方向，第一倾角</translation>
    </message>
    <message>
      <source>direction of the rotation axis, second tilt</source>
      <translation>旋转轴方向，第二倾角</translation>
    </message>
    <message>
      <source>farther away from the {v1}</source>
      <translation>移远离{v1}</translation>
    </message>
    <message>
      <source>first half: </source>
      <translation>前一半：</translation>
    </message>
    <message>
      <source>focus in mm</source>
      <translation>对焦距离 (mm)</translation>
    </message>
    <message>
      <source>guide direction</source>
      <translation>导轨方向</translation>
    </message>
    <message>
      <source>guide scale</source>
      <translation>导轨比例</translation>
    </message>
    <message>
      <source>in the lower left corner</source>
      <translation>在左下角</translation>
    </message>
    <message>
      <source>in the lower part</source>
      <translation>在下部</translation>
    </message>
    <message>
      <source>in the lower right corner</source>
      <translation>在右下角</translation>
    </message>
    <message>
      <source>in the middle</source>
      <translation>在中间</translation>
    </message>
    <message>
      <source>in the upper left corner</source>
      <translation>在左上角</translation>
    </message>
    <message>
      <source>in the upper part</source>
      <translation>在上部</translation>
    </message>
    <message>
      <source>in the upper right corner</source>
      <translation>在右上角</translation>
    </message>
    <message>
      <source>is hardly observable from these poses</source>
      <translation>由这些位姿几乎不可观测</translation>
    </message>
    <message>
      <source>is the least certain</source>
      <translation>最不确定</translation>
    </message>
    <message>
      <source>it does not show the board position detected by cameras {v1} saw</source>
      <translation>它显示的不是相机 {v1} 所检测到的标定板位置</translation>
    </message>
    <message>
      <source>it has no camera {v1}</source>
      <translation>它没有相机 {v1}</translation>
    </message>
    <message>
      <source>it was knocked or refocused, or its mounting gave way: calibrate the cameras again.</source>
      <translation>它被碰撞或重新对焦，或其固定松动：请重新标定相机。</translation>
    </message>
    <message>
      <source>iteration {v1}</source>
      <translation>迭代 {v1}</translation>
    </message>
    <message>
      <source>its bearing has play, the robot warmed up during the calibration, or the board moved on the table</source>
      <translation>其轴承有间隙、机器人在标定过程中升温，或标定板在转台上移动了</translation>
    </message>
    <message>
      <source>its carriage has play, or the robot warmed up during the calibration</source>
      <translation>其滑座有间隙，或机器人在标定过程中升温</translation>
    </message>
    <message>
      <source>its rms of {v1} px is more than {v2} times the median of {v3} px: its corners were found in a wrong place, or the image is blurred</source>
      <translation>其 rms 为 {v1} px，超过中位数 {v3} px 的 {v2} 倍：角点找错了位置，或图像模糊</translation>
    </message>
    <message>
      <source>joint solution of the rig</source>
      <translation>测量系统联合求解</translation>
    </message>
    <message>
      <source>left edge</source>
      <translation>左边缘</translation>
    </message>
    <message>
      <source>lies {v1} px from its expected position; {v2} px is the limit</source>
      <translation>距预期位置 {v1} px；限值为 {v2} px</translation>
    </message>
    <message>
      <source>lower edge</source>
      <translation>下边缘</translation>
    </message>
    <message>
      <source>maximum likelihood</source>
      <translation>最大似然</translation>
    </message>
    <message>
      <source>nearer to the {v1}</source>
      <translation>移近{v1}</translation>
    </message>
    <message>
      <source>not found</source>
      <translation>未找到</translation>
    </message>
    <message>
      <source>observation {v1}</source>
      <translation>观测 {v1}</translation>
    </message>
    <message>
      <source>of a measurement uncertainty of 0.05 mm, 0.02 mm is hardly noticeable and 0.05 mm is all of it</source>
      <translation>测量不确定度为 0.05 mm 时，0.02 mm 几乎察觉不到，而 0.05 mm 即为全部</translation>
    </message>
    <message>
      <source>on the left side</source>
      <translation>在左侧</translation>
    </message>
    <message>
      <source>on the right side</source>
      <translation>在右侧</translation>
    </message>
    <message>
      <source>once more</source>
      <translation>再一次</translation>
    </message>
    <message>
      <source>once {v1} nearer to the {v2} and once {v3} farther away</source>
      <translation>移近{v2} {v1} 一次，再移远 {v3} 一次</translation>
    </message>
    <message>
      <source>one more view with</source>
      <translation>再拍一个视图，包含</translation>
    </message>
    <message>
      <source>place of the board along x</source>
      <translation>标定板沿 x 的位置</translation>
    </message>
    <message>
      <source>place of the board along y (along the guide)</source>
      <translation>标定板沿 y（沿导轨）的位置</translation>
    </message>
    <message>
      <source>place of the board along z</source>
      <translation>标定板沿 z 的位置</translation>
    </message>
    <message>
      <source>place of the camera along the flange's x</source>
      <translation>相机沿法兰 x 的位置</translation>
    </message>
    <message>
      <source>place of the camera along the flange's y</source>
      <translation>相机沿法兰 y 的位置</translation>
    </message>
    <message>
      <source>place of the camera along the flange's z</source>
      <translation>相机沿法兰 z 的位置</translation>
    </message>
    <message>
      <source>place of the rotation axis, first way across</source>
      <translation>旋转轴的位置，第一横向</translation>
    </message>
    <message>
      <source>place of the rotation axis, second way across</source>
      <translation>旋转轴的位置，第二横向</translation>
    </message>
    <message>
      <source>points from the projector complement those of two cameras and should be as certain</source>
      <translation>投影仪的点补充两台相机的点，应同样确定</translation>
    </message>
    <message>
      <source>points measured by camera {v1} and the projector, relative to each other (rms)</source>
      <translation>相机 {v1} 与投影仪测得的点的相对位置 (rms)</translation>
    </message>
    <message>
      <source>points of the volume relative to each other (rms)</source>
      <translation>空间各点的相对位置（均方根）</translation>
    </message>
    <message>
      <source>points {v1} mm in front of the camera (rms, across the line of sight)</source>
      <translation>相机前方 {v1} mm 处的点 (rms，垂直于视线)</translation>
    </message>
    <message>
      <source>projector</source>
      <translation>投影仪</translation>
    </message>
    <message>
      <source>registration of overlapping views corrects 0.1 mm with ease, and starts safely up to 0.5 mm</source>
      <translation>重叠视图的配准可轻松修正 0.1 mm，并能从不超过 0.5 mm 可靠开始</translation>
    </message>
    <message>
      <source>right edge</source>
      <translation>右边缘</translation>
    </message>
    <message>
      <source>rotation of the board about the guide frame's x</source>
      <translation>标定板绕导轨坐标系 x 的旋转</translation>
    </message>
    <message>
      <source>rotation of the board about the guide frame's y (along the guide)</source>
      <translation>标定板绕导轨坐标系 y（沿导轨）的旋转</translation>
    </message>
    <message>
      <source>rotation of the board about the guide frame's z</source>
      <translation>标定板绕导轨坐标系 z 的旋转</translation>
    </message>
    <message>
      <source>rotation of the camera about the flange's x</source>
      <translation>相机绕法兰 x 的旋转</translation>
    </message>
    <message>
      <source>rotation of the camera about the flange's y</source>
      <translation>相机绕法兰 y 的旋转</translation>
    </message>
    <message>
      <source>rotation of the camera about the flange's z</source>
      <translation>相机绕法兰 z 的旋转</translation>
    </message>
    <message>
      <source>scale of the guide</source>
      <translation>导轨的比例</translation>
    </message>
    <message>
      <source>second half: </source>
      <translation>后一半：</translation>
    </message>
    <message>
      <source>several cameras</source>
      <translation>多台相机</translation>
    </message>
    <message>
      <source>solutions from two halves of the views differ by {v1} px for {v2}, with {v3} px predicted</source>
      <translation>两半视图的解对{v2}相差 {v1} px，预计为 {v3} px</translation>
    </message>
    <message>
      <source>straight line of the guide</source>
      <translation>导轨的直线</translation>
    </message>
    <message>
      <source>straight line through the positions</source>
      <translation>过各位置的直线</translation>
    </message>
    <message>
      <source>the combined expanded uncertainty of {v1} (k = 2)</source>
      <translation>合成扩展不确定度 {v1} (k = 2)</translation>
    </message>
    <message>
      <source>the fringes run in one direction only; vertical and horizontal ones are needed</source>
      <translation>条纹只有一个方向；需要竖直和水平两个方向</translation>
    </message>
    <message>
      <source>the hand-eye transform</source>
      <translation>手眼变换</translation>
    </message>
    <message>
      <source>the image</source>
      <translation>图像</translation>
    </message>
    <message>
      <source>the images of cameras {v1} and {v2} were exchanged</source>
      <translation>相机 {v1} 与 {v2} 的图像互换了</translation>
    </message>
    <message>
      <source>the linear guide</source>
      <translation>直线导轨</translation>
    </message>
    <message>
      <source>the phases around {v1} marks are known; {v2} are needed</source>
      <translation>仅知 {v1} 个标志点周围的相位；需要 {v2} 个</translation>
    </message>
    <message>
      <source>the projector</source>
      <translation>投影仪</translation>
    </message>
    <message>
      <source>the projector's image</source>
      <translation>投影仪图像</translation>
    </message>
    <message>
      <source>the rig</source>
      <translation>测量系统</translation>
    </message>
    <message>
      <source>the rotation axis</source>
      <translation>旋转轴线</translation>
    </message>
    <message>
      <source>the {v1}</source>
      <translation>{v1}</translation>
    </message>
    <message>
      <source>there are too few views to compare two halves</source>
      <translation>视图太少，无法比较两半</translation>
    </message>
    <message>
      <source>to the left</source>
      <translation>向左</translation>
    </message>
    <message>
      <source>to the right</source>
      <translation>向右</translation>
    </message>
    <message>
      <source>upper edge</source>
      <translation>上边缘</translation>
    </message>
    <message>
      <source>view {v1}</source>
      <translation>视图 {v1}</translation>
    </message>
    <message>
      <source>views held back fit with {v1} px rms where {v2} px was predicted</source>
      <translation>留出的视图拟合 rms 为 {v1} px，预计为 {v2} px</translation>
    </message>
    <message>
      <source>views of one part relative to each other (rms)</source>
      <translation>同一工件各视图的相对位置（均方根）</translation>
    </message>
    <message>
      <source>views that are off by less than 0.05 mm need no registration, those up to 0.2 mm register safely</source>
      <translation>偏差小于 0.05 mm 的视图无需配准，不超过 0.2 mm 的可可靠配准</translation>
    </message>
    <message>
      <source>without part {v1}: </source>
      <translation>不含第 {v1} 部分：</translation>
    </message>
    <message>
      <source>wrong board</source>
      <translation>标定板不符</translation>
    </message>
    <message>
      <source>{v1} angles do not belong to {v2} table positions.</source>
      <translation>{v1} 个角度与 {v2} 个转台位置不符。</translation>
    </message>
    <message>
      <source>{v1} distortion coefficients are not offered.</source>
      <translation>不提供 {v1} 个畸变系数。</translation>
    </message>
    <message>
      <source>{v1} has turned by {v2}° since the calibration: its image is off by {v3} (the calibration left {v4} px), which moves measured points by {v5} mm; {v6}</source>
      <translation>{v1}自标定以来转动了 {v2}°：其图像偏移 {v3}（标定的残差为 {v4} px），使测量点移动 {v5} mm；{v6}</translation>
    </message>
    <message>
      <source>{v1} has {v2} {v3} of the board; at least {v4} are needed.</source>
      <translation>{v1} 有标定板的 {v2} {v3}；至少需要 {v4} 个。</translation>
    </message>
    <message>
      <source>{v1} images</source>
      <translation>{v1} 幅图像</translation>
    </message>
    <message>
      <source>{v1} is not a kind of calibration.</source>
      <translation>{v1} 不是一种标定。</translation>
    </message>
    <message>
      <source>{v1} is ± {v2} {v3}, {v4} times what is stated or usual (± {v5} {v6}): {v7}.</source>
      <translation>{v1}为 ± {v2} {v3}，是所述或通常值（± {v5} {v6}）的 {v4} 倍：{v7}。</translation>
    </message>
    <message>
      <source>{v1} more guide positions are needed.</source>
      <translation>还需要 {v1} 个导轨位置。</translation>
    </message>
    <message>
      <source>{v1} more table positions are needed.</source>
      <translation>还需要 {v1} 个转台位置。</translation>
    </message>
    <message>
      <source>{v1} more times</source>
      <translation>再 {v1} 次</translation>
    </message>
    <message>
      <source>{v1} more views, each with</source>
      <translation> {v1} 个视图，每个都取</translation>
    </message>
    <message>
      <source>{v1} observations of the board over {v2}° of the table do not determine the rig.</source>
      <translation>在转台 {v2}° 范围内 {v1} 次标定板观测不能确定测量系统。</translation>
    </message>
    <message>
      <source>{v1} of its corners were found in a wrong place</source>
      <translation>其中 {v1} 个角点找错了位置</translation>
    </message>
    <message>
      <source>{v1} of {v2} centres of arcs are uncertain by more than {v3} mm: the worst, of corner {v4} on an arc of {v5} mm, by {v6} mm. Turn the table further, or trust maximum likelihood, which does not need the centres.</source>
      <translation>{v2} 个圆弧圆心中有 {v1} 个的不确定度超过 {v3} mm：最差的是角点 {v4}，其圆弧为 {v5} mm，不确定度 {v6} mm。请让转台转得更远，或采用不需要圆心的最大似然法。</translation>
    </message>
    <message>
      <source>{v1} of {v2} observations were rejected: examine the reasons and replace them.</source>
      <translation>{v2} 个观测中有 {v1} 个被剔除：请查看原因并替换它们。</translation>
    </message>
    <message>
      <source>{v1} poses do not determine the hand-eye transform.</source>
      <translation>{v1} 个位姿不能确定手眼变换。</translation>
    </message>
    <message>
      <source>{v1} ppm of every length</source>
      <translation>每个长度 {v1} ppm</translation>
    </message>
    <message>
      <source>{v1} robot poses do not belong to {v2} board poses.</source>
      <translation>{v1} 个机器人位姿与 {v2} 个标定板位姿不符。</translation>
    </message>
    <message>
      <source>{v1} slide positions over {v2} mm do not determine the guide.</source>
      <translation>{v2} mm 范围内 {v1} 个滑台位置不能确定导轨。</translation>
    </message>
    <message>
      <source>{v1} table positions with {v2} corners do not determine the axis.</source>
      <translation>{v1} 个转台位置、{v2} 个角点不能确定轴线。</translation>
    </message>
    <message>
      <source>{v1} views are too few to hold some back.</source>
      <translation>{v1} 个视图太少，无法保留一部分。</translation>
    </message>
    <message>
      <source>{v1} {v2} could not be used; {v3}: {v4}.</source>
      <translation>{v1} 个{v2}无法使用；{v3}：{v4}。</translation>
    </message>
    <message>
      <source>{v1} {v2}°, {v3}° are wanted</source>
      <translation>{v1}：{v2}°，需要 {v3}°</translation>
    </message>
    <message>
      <source>{v1} × {v2} circles</source>
      <translation>{v1} × {v2} 个圆点</translation>
    </message>
    <message>
      <source>{v1} × {v2} corners</source>
      <translation>{v1} × {v2} 个角点</translation>
    </message>
    <message>
      <source>{v1}, more than {v2}: something changed in between, or one of the stated uncertainties is too small.</source>
      <translation>{v1}，大于 {v2}：期间发生了变化，或某个给出的不确定度过小。</translation>
    </message>
    <message>
      <source>{v1}, within {v2}.</source>
      <translation>{v1}，在 {v2} 以内。</translation>
    </message>
    <message>
      <source>{v1}, within {v2}; but its values differ by {v3} times their combined standard deviations: the cameras were knocked, refocused or warmed up in between.</source>
      <translation>{v1}，在 {v2} 以内；但其数值之差为合成标准差的 {v3} 倍：期间相机被碰动、重新调焦或升温。</translation>
    </message>
    <message>
      <source>{v1}. Only usable for another reason: {v2}</source>
      <translation>{v1}。仅因其他原因可用：{v2}</translation>
    </message>
    <message>
      <source>{v1}: corner {v2} rejected, it {v3}.</source>
      <translation>{v1}：角点 {v2} 被剔除，它{v3}。</translation>
    </message>
    <message>
      <source>{v1}: not observable from these poses</source>
      <translation>{v1}：由这些位姿不可观测</translation>
    </message>
    <message>
      <source>{v1}: {v2} (± {v3} mm at the part)</source>
      <translation>{v1}：{v2}（工件处 ± {v3} mm）</translation>
    </message>
    <message>
      <source>{v1}: {v2} more {v3} beyond {v4}{v5}</source>
      <translation>{v1}：再取 {v2} 个{v3}，超出 {v4}{v5}</translation>
    </message>
  </context>
  <context>
    <name>core.calibration_session</name>
    <message>
      <source>Add observations first.</source>
      <translation>请先添加观测。</translation>
    </message>
    <message>
      <source>An image ({v1}) cannot be encoded.</source>
      <translation>图像 ({v1}) 无法编码。</translation>
    </message>
    <message>
      <source>An observation needs an image.</source>
      <translation>观测需要图像。</translation>
    </message>
    <message>
      <source>Check the permissions.</source>
      <translation>请检查权限。</translation>
    </message>
    <message>
      <source>Choose a new folder, or continue the session that is there.</source>
      <translation>请选择新文件夹，或继续已有的会话。</translation>
    </message>
    <message>
      <source>Choose a table with one line per position of the board, or the folder in which a project keeps its views of the board.</source>
      <translation>请选择每个标定板位置一行的表格，或项目保存其标定板视图的文件夹。</translation>
    </message>
    <message>
      <source>Every observation needs images of its own.</source>
      <translation>每个观测都需要自己的图像。</translation>
    </message>
    <message>
      <source>Fringes calibrate a projector only.</source>
      <translation>条纹只能标定投影仪。</translation>
    </message>
    <message>
      <source>Give fringes instead.</source>
      <translation>请改为给出条纹。</translation>
    </message>
    <message>
      <source>Give fringes of one projector.</source>
      <translation>请给出同一投影仪的条纹。</translation>
    </message>
    <message>
      <source>Give images of one camera at one resolution.</source>
      <translation>请给出同一相机同一分辨率的图像。</translation>
    </message>
    <message>
      <source>Give it with every observation.</source>
      <translation>请随每次观测给出。</translation>
    </message>
    <message>
      <source>Give one image per camera.</source>
      <translation>请每台相机给出一幅图像。</translation>
    </message>
    <message>
      <source>Give one line per board position.</source>
      <translation>请每个标定板位置给出一行。</translation>
    </message>
    <message>
      <source>Give plain images of the board.</source>
      <translation>请给出标定板的普通图像。</translation>
    </message>
    <message>
      <source>It was recorded with an earlier version: record the position again.</source>
      <translation>它由较早版本录制：请重新录制该位置。</translation>
    </message>
    <message>
      <source>Light the whole board with the fringes, neither too dark nor clipped.</source>
      <translation>请用条纹照亮整块标定板，既不过暗也不过曝。</translation>
    </message>
    <message>
      <source>Name a session, a result that was accepted, a cameras.json, or a project with a calibrated rig.</source>
      <translation>请指定一个会话、一个已接受的结果、一个 cameras.json，或一个测量系统已标定的项目。</translation>
    </message>
    <message>
      <source>No camera found the board.</source>
      <translation>没有相机找到标定板。</translation>
    </message>
    <message>
      <source>Observation {v1} was removed before.</source>
      <translation>观测 {v1} 此前已移除。</translation>
    </message>
    <message>
      <source>Only what was undone, and nothing changed since, can be redone.</source>
      <translation>只有被撤销且之后无更改的操作才能重做。</translation>
    </message>
    <message>
      <source>Record vertical and horizontal fringes at every position: `measureapp patterns export` writes such a set.</source>
      <translation>请在每个位置录制垂直和水平条纹：`measureapp patterns export` 写出这样的图案集。</translation>
    </message>
    <message>
      <source>Restore it from a backup, or start again.</source>
      <translation>请从备份恢复，或重新开始。</translation>
    </message>
    <message>
      <source>Restore it from a backup.</source>
      <translation>请从备份恢复。</translation>
    </message>
    <message>
      <source>Show it whole, sharp and evenly lit.</source>
      <translation>请完整、清晰、均匀照明地显示它。</translation>
    </message>
    <message>
      <source>Start one by naming the kind, the board and images.</source>
      <translation>请指定类型、标定板和图像以开始。</translation>
    </message>
    <message>
      <source>Take it again.</source>
      <translation>请重新拍摄。</translation>
    </message>
    <message>
      <source>The fringes of observation {v1} were not kept, so the projector's marks cannot be read again.</source>
      <translation>观测 {v1} 的条纹未保留，因此无法再次读取投影仪的标记。</translation>
    </message>
    <message>
      <source>The fringes of {v1} run over {v2} × {v3} px of the projector, those before over {v4} × {v5} px.</source>
      <translation>{v1} 的条纹覆盖投影仪的 {v2} × {v3} px，此前的为 {v4} × {v5} px。</translation>
    </message>
    <message>
      <source>The image of camera {v1} is the same as in observation {v2}.</source>
      <translation>相机 {v1} 的图像与观测 {v2} 中的相同。</translation>
    </message>
    <message>
      <source>The image of camera {v1} is {v2} × {v3} px; {v4} × {v5} px are expected.</source>
      <translation>相机 {v1} 的图像为 {v2} × {v3} px；应为 {v4} × {v5} px。</translation>
    </message>
    <message>
      <source>The images have no read-back of: {v1}.</source>
      <translation>图像没有以下各项的读回：{v1}。</translation>
    </message>
    <message>
      <source>The name {v1} is not in both {v2} and {v3}.</source>
      <translation>名称 {v1} 未同时出现在 {v2} 和 {v3} 中。</translation>
    </message>
    <message>
      <source>The read-back lacks {v1}.</source>
      <translation>读回缺少 {v1}。</translation>
    </message>
    <message>
      <source>There is no camera {v1} here.</source>
      <translation>这里没有相机 {v1}。</translation>
    </message>
    <message>
      <source>There is no observation {v1}.</source>
      <translation>没有观测 {v1}。</translation>
    </message>
    <message>
      <source>There is nothing to redo.</source>
      <translation>没有可重做的操作。</translation>
    </message>
    <message>
      <source>There is nothing to undo.</source>
      <translation>没有可撤销的操作。</translation>
    </message>
    <message>
      <source>Undo restores it.</source>
      <translation>撤销可恢复。</translation>
    </message>
    <message>
      <source>Use the same names.</source>
      <translation>请使用相同的名称。</translation>
    </message>
    <message>
      <source>board in {v1}</source>
      <translation>{v1} 中的标定板</translation>
    </message>
    <message>
      <source>detecting the board in {v1}</source>
      <translation>正在 {v1} 中检测标定板</translation>
    </message>
    <message>
      <source>fringes of {v1}</source>
      <translation>{v1} 的条纹</translation>
    </message>
    <message>
      <source>from a camera</source>
      <translation>来自相机</translation>
    </message>
    <message>
      <source>image {v1}</source>
      <translation>图像 {v1}</translation>
    </message>
    <message>
      <source>marks that are not numbers</source>
      <translation>标志点不是数值</translation>
    </message>
    <message>
      <source>none yet</source>
      <translation>尚无</translation>
    </message>
    <message>
      <source>observation {v1}, {v2}{v3}</source>
      <translation>观测 {v1}，{v2}{v3}</translation>
    </message>
    <message>
      <source>removed by hand</source>
      <translation>手动剔除</translation>
    </message>
    <message>
      <source>schema_version is {v1}, not {v2}</source>
      <translation>schema_version 为 {v1}，而非 {v2}</translation>
    </message>
    <message>
      <source>the list of actions is inconsistent</source>
      <translation>操作列表不一致</translation>
    </message>
    <message>
      <source>{v1} cannot be read: {v2}.</source>
      <translation>无法读取 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>{v1} cannot be removed: {v2}.</source>
      <translation>无法移除 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>{v1} cannot be used: {v2}.</source>
      <translation>无法使用 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>{v1} has changed since it was saved: its checksum differs.</source>
      <translation>{v1} 自保存后已更改：其校验和不同。</translation>
    </message>
    <message>
      <source>{v1} has {v2} fringes only; the projector needs those of both directions.</source>
      <translation>{v1} 只有{v2}条纹；投影仪需要两个方向的条纹。</translation>
    </message>
    <message>
      <source>{v1} has {v2} lines for {v3} board positions.</source>
      <translation>{v1} 有 {v2} 行，而标定板位置有 {v3} 个。</translation>
    </message>
    <message>
      <source>{v1} holds no calibration session.</source>
      <translation>{v1} 中没有标定会话。</translation>
    </message>
    <message>
      <source>{v1} holds no calibration.</source>
      <translation>{v1} 中没有标定。</translation>
    </message>
    <message>
      <source>{v1} holds no calibration: {v2}.</source>
      <translation>{v1} 中没有标定：{v2}。</translation>
    </message>
    <message>
      <source>{v1} is calibrated from fringes on the board.</source>
      <translation>{v1}由标定板上的条纹标定。</translation>
    </message>
    <message>
      <source>{v1} is not JSON: {v2}.</source>
      <translation>{v1} 不是 JSON：{v2}。</translation>
    </message>
    <message>
      <source>{v1} is not an empty folder.</source>
      <translation>{v1} 不是空文件夹。</translation>
    </message>
    <message>
      <source>{v1} is taken again. {v2}</source>
      <translation>重拍 {v1}。{v2}</translation>
    </message>
    <message>
      <source>{v1} of {v2} viewpoints failed: {v3}</source>
      <translation>{v2} 个视点中 {v1} 个失败：{v3}</translation>
    </message>
  </context>
  <context>
    <name>core.camera_basler</name>
    <message>
      <source> after {v1} triggers</source>
      <translation>（{v1} 次触发之后）</translation>
    </message>
    <message>
      <source>All {v1} images of the sequence of camera {v2} are triggered.</source>
      <translation>相机 {v2} 序列的全部 {v1} 幅图像已触发。</translation>
    </message>
    <message>
      <source>Arm it first.</source>
      <translation>请先使其就绪。</translation>
    </message>
    <message>
      <source>Arm it for more images.</source>
      <translation>请使其为更多图像就绪。</translation>
    </message>
    <message>
      <source>Camera {v1} ({v2}) cannot be opened: {v3}.</source>
      <translation>相机 {v1} ({v2}) 无法打开：{v3}。</translation>
    </message>
    <message>
      <source>Camera {v1} ({v2}) does not answer any more: {v3}.</source>
      <translation>相机 {v1}（{v2}）不再应答：{v3}。</translation>
    </message>
    <message>
      <source>Camera {v1} ({v2}) is controlled by another program; it was tried for {v3} s.</source>
      <translation>相机 {v1} ({v2}) 被另一程序控制；已尝试 {v3} s。</translation>
    </message>
    <message>
      <source>Camera {v1} could not be released.</source>
      <translation>相机 {v1} 无法释放。</translation>
    </message>
    <message>
      <source>Camera {v1} delivered no image within {v2} s{v3}.</source>
      <translation>相机 {v1} 在 {v2} s 内没有送出图像{v3}。</translation>
    </message>
    <message>
      <source>Camera {v1} did not answer within {v2} s of connecting.</source>
      <translation>相机 {v1} 在连接后 {v2} s 内没有应答。</translation>
    </message>
    <message>
      <source>Camera {v1} did not become ready within {v2} s.</source>
      <translation>相机 {v1} 在 {v2} s 内未就绪。</translation>
    </message>
    <message>
      <source>Camera {v1} does not accept triggers after {v2} s.</source>
      <translation>相机 {v1} 在 {v2} s 后仍不接受触发。</translation>
    </message>
    <message>
      <source>Camera {v1} does not accept {v2} {v3} at {v4} {v5}.</source>
      <translation>相机 {v1} 在 {v4} {v5} 时不接受 {v2} {v3}。</translation>
    </message>
    <message>
      <source>Camera {v1} failed: {v2}.</source>
      <translation>相机 {v1} 失败：{v2}。</translation>
    </message>
    <message>
      <source>Camera {v1} got an image of another camera.</source>
      <translation>相机 {v1} 收到另一相机的图像。</translation>
    </message>
    <message>
      <source>Camera {v1} has no setting {v2}.</source>
      <translation>相机 {v1} 没有设置 {v2}。</translation>
    </message>
    <message>
      <source>Camera {v1} has no {v2} {v3} (it has: {v4}).</source>
      <translation>相机 {v1} 没有 {v2} {v3}（有：{v4}）。</translation>
    </message>
    <message>
      <source>Camera {v1} has {v2} pixels of {v3}, fewer than the {v4} of the rig description.</source>
      <translation>相机 {v1} 有 {v2} 像素{v3}，少于测量系统描述的 {v4}。</translation>
    </message>
    <message>
      <source>Camera {v1} is closed.</source>
      <translation>相机 {v1} 已关闭。</translation>
    </message>
    <message>
      <source>Camera {v1} is not armed for triggers by the program.</source>
      <translation>相机 {v1} 未由程序为触发就绪。</translation>
    </message>
    <message>
      <source>Camera {v1} is not armed.</source>
      <translation>相机 {v1} 未就绪。</translation>
    </message>
    <message>
      <source>Camera {v1} reads back {v2} = {v3} after {v4} was set: it ignored or limited the value.</source>
      <translation>设置 {v4} 后相机 {v1} 读回 {v2} = {v3}：它忽略或限制了该值。</translation>
    </message>
    <message>
      <source>Camera {v1} refused {v2} = {v3}: {v4}.</source>
      <translation>相机 {v1} 拒绝 {v2} = {v3}：{v4}。</translation>
    </message>
    <message>
      <source>Camera {v1}: no Basler camera with serial number {v2} answers. Found: {v3}.</source>
      <translation>相机 {v1}：没有序列号为 {v2} 的 Basler 相机应答。找到：{v3}。</translation>
    </message>
    <message>
      <source>Camera {v1}: no Basler camera with serial number {v2} answers. None was found.</source>
      <translation>相机 {v1}：没有序列号为 {v2} 的 Basler 相机应答。一台也未找到。</translation>
    </message>
    <message>
      <source>Check its cable, its power and the network card, then connect again.</source>
      <translation>请检查其电缆、电源和网卡，然后重新连接。</translation>
    </message>
    <message>
      <source>Check its cable, packet size and inter-packet delay.</source>
      <translation>请检查其电缆、数据包大小和数据包间隔。</translation>
    </message>
    <message>
      <source>Check its power and its cable.</source>
      <translation>请检查其电源和电缆。</translation>
    </message>
    <message>
      <source>Check its trigger and the load of its link.</source>
      <translation>请检查其触发和连接的负载。</translation>
    </message>
    <message>
      <source>Check its trigger line.</source>
      <translation>请检查其触发线。</translation>
    </message>
    <message>
      <source>Check its trigger settings.</source>
      <translation>请检查其触发设置。</translation>
    </message>
    <message>
      <source>Check power and cables, and that network card and cameras have addresses in one subnet.</source>
      <translation>请检查电源和电缆，并确认网卡与相机在同一子网。</translation>
    </message>
    <message>
      <source>Check the driver's settings in the rig description, and the camera's model and firmware.</source>
      <translation>请检查测量系统描述中的驱动设置，以及相机的型号和固件。</translation>
    </message>
    <message>
      <source>Choose a value that the camera supports, and close other programs that may set it.</source>
      <translation>请选择相机支持的值，并关闭可能设置它的其他程序。</translation>
    </message>
    <message>
      <source>Choose multiples of its step (often 2 or 16).</source>
      <translation>请选择其步长的倍数（常为 2 或 16）。</translation>
    </message>
    <message>
      <source>Close the other program (pylon Viewer, another MeasureApp, also on another computer), then connect again.</source>
      <translation>请关闭另一程序（pylon Viewer、另一个 MeasureApp，也包括另一台计算机上的），然后重新连接。</translation>
    </message>
    <message>
      <source>Correct the serial number in the rig description, or check power, cable and IP address: camera and network card need one subnet.</source>
      <translation>请更正测量系统描述中的序列号，或检查电源、电缆和 IP 地址：相机与网卡须在同一子网。</translation>
    </message>
    <message>
      <source>Correct width_px and height_px in the rig description, or offset_px in the settings.</source>
      <translation>请更正测量系统描述中的 width_px 和 height_px，或设置中的 offset_px。</translation>
    </message>
    <message>
      <source>Install it: pip install pypylon.</source>
      <translation>请安装：pip install pypylon。</translation>
    </message>
    <message>
      <source>Lengthen the time between triggers.</source>
      <translation>请加大触发之间的时间。</translation>
    </message>
    <message>
      <source>Restart the program.</source>
      <translation>请重新启动程序。</translation>
    </message>
    <message>
      <source>The driver camera_basler needs the package pypylon, which cannot be imported: {v1}.</source>
      <translation>驱动 camera_basler 需要 pypylon 包，但无法导入：{v1}。</translation>
    </message>
    <message>
      <source>a call has not returned</source>
      <translation>某个调用没有返回</translation>
    </message>
    <message>
      <source>image {v1} came after image {v2}</source>
      <translation>图像 {v1} 在图像 {v2} 之后到达</translation>
    </message>
    <message>
      <source>image {v1} was exposed for {v2} µs, not {v3} µs</source>
      <translation>图像 {v1} 曝光了 {v2} µs，而非 {v3} µs</translation>
    </message>
    <message>
      <source>it needs a whole number</source>
      <translation>需要整数</translation>
    </message>
    <message>
      <source>it sent image {v1} after {v2} triggers</source>
      <translation>{v2} 次触发后它送出了图像 {v1}</translation>
    </message>
    <message>
      <source>it sent image {v1} of a sequence of {v2}</source>
      <translation>它在 {v2} 幅的序列中送出了图像 {v1}</translation>
    </message>
    <message>
      <source>it was removed</source>
      <translation>已被移除</translation>
    </message>
    <message>
      <source>its exposure reads {v1} µs, and {v2} µs was set</source>
      <translation>其曝光读出为 {v1} µs，而设定为 {v2} µs</translation>
    </message>
    <message>
      <source>its stream has ended</source>
      <translation>其数据流已结束</translation>
    </message>
    <message>
      <source>the check sequence of the image does not fit its pixels</source>
      <translation>图像的校验序列与像素不符</translation>
    </message>
    <message>
      <source>the image has {v1} of {v2} bytes</source>
      <translation>图像只有 {v2} 字节中的 {v1} 字节</translation>
    </message>
    <message>
      <source>the image is damaged or incomplete ({v1})</source>
      <translation>图像损坏或不完整（{v1}）</translation>
    </message>
    <message>
      <source>{v1} of {v2} bytes</source>
      <translation>{v2} 字节中的 {v1} 字节</translation>
    </message>
    <message>
      <source>{v1} triggers came while it was busy and were ignored</source>
      <translation>{v1} 次触发在其忙时到来，已被忽略</translation>
    </message>
  </context>
  <context>
    <name>core.camera_folder</name>
    <message>
      <source>Camera {v1} delivered no image within {v2} s.</source>
      <translation>相机 {v1} 在 {v2} s 内没有送出图像。</translation>
    </message>
    <message>
      <source>Camera {v1} did not finish within {v2} s.</source>
      <translation>相机 {v1} 在 {v2} s 内没有完成。</translation>
    </message>
    <message>
      <source>Camera {v1} has no images recorded at {v2} µs.</source>
      <translation>相机 {v1} 没有 {v2} µs 下记录的图像。</translation>
    </message>
    <message>
      <source>Choose one of {v1} µs.</source>
      <translation>请从 {v1} µs 中选择。</translation>
    </message>
    <message>
      <source>Copy them, or correct the manifest.</source>
      <translation>请复制它们，或更正清单。</translation>
    </message>
    <message>
      <source>Correct bit_depth in the rig description, or convert the images.</source>
      <translation>请更正测量系统描述中的 bit_depth，或转换图像。</translation>
    </message>
    <message>
      <source>Correct exposure_in_name.</source>
      <translation>请更正 exposure_in_name。</translation>
    </message>
    <message>
      <source>Correct the setting files, or the folder.</source>
      <translation>请更正设置 files，或文件夹。</translation>
    </message>
    <message>
      <source>Correct the setting folder.</source>
      <translation>请更正设置 folder。</translation>
    </message>
    <message>
      <source>Correct the setting manifest, or the file.</source>
      <translation>请更正设置 manifest，或文件。</translation>
    </message>
    <message>
      <source>Correct the size in the rig description, or choose images of this camera.</source>
      <translation>请更正测量系统描述中的尺寸，或选择此相机的图像。</translation>
    </message>
    <message>
      <source>Give every exposure.</source>
      <translation>请给出每个曝光。</translation>
    </message>
    <message>
      <source>Image {v1} has {v2} × {v3} px, and camera {v4} {v5} × {v6} px.</source>
      <translation>图像 {v1} 为 {v2} × {v3} px，而相机 {v4} 为 {v5} × {v6} px。</translation>
    </message>
    <message>
      <source>Image {v1} has {v2}, which does not fit the {v3} bit of camera {v4}.</source>
      <translation>图像 {v1} 为 {v2}，不适合相机 {v4} 的 {v3} 位。</translation>
    </message>
    <message>
      <source>Rename it, or correct exposure_in_name or files.</source>
      <translation>请重命名，或更正 exposure_in_name 或 files。</translation>
    </message>
    <message>
      <source>Set at_end = "loop" to begin again.</source>
      <translation>请设置 at_end = "loop" 以重新开始。</translation>
    </message>
    <message>
      <source>Some images of {v1} have an exposure and some have none.</source>
      <translation>{v1} 的部分图像有曝光，部分没有。</translation>
    </message>
    <message>
      <source>The exposure in the name of {v1} is not a number.</source>
      <translation>{v1} 名称中的曝光不是数字。</translation>
    </message>
    <message>
      <source>The folder {v1} has no file {v2}.</source>
      <translation>文件夹 {v1} 中没有文件 {v2}。</translation>
    </message>
    <message>
      <source>The folder {v1} of recorded images does not exist.</source>
      <translation>录制图像的文件夹 {v1} 不存在。</translation>
    </message>
    <message>
      <source>The manifest {v1} cannot be read: {v2}.</source>
      <translation>无法读取清单 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>The manifest {v1} is not valid TOML: {v2}.</source>
      <translation>清单 {v1} 不是有效的 TOML：{v2}。</translation>
    </message>
    <message>
      <source>The manifest {v1}: {v2}.</source>
      <translation>清单 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>The name of {v1} has no exposure by the pattern {v2}.</source>
      <translation>按模式 {v2}，{v1} 的名称没有曝光。</translation>
    </message>
    <message>
      <source>The recording of camera {v1} in {v2} has ended after {v3} images.</source>
      <translation>相机 {v1} 在 {v2} 中的录制在 {v3} 幅图像后结束。</translation>
    </message>
    <message>
      <source>Trigger it, or arm it for more images.</source>
      <translation>请触发它，或为更多图像做好准备。</translation>
    </message>
    <message>
      <source>Wait longer, or lower time_scale.</source>
      <translation>请等待更久，或减小 time_scale。</translation>
    </message>
    <message>
      <source>levels up to {v1}</source>
      <translation>灰度最高 {v1}</translation>
    </message>
    <message>
      <source>{v1} has no group (?P&lt;us&gt;…) or (?P&lt;ms&gt;…)</source>
      <translation>{v1} 没有组 (?P&lt;us&gt;…) 或 (?P&lt;ms&gt;…)</translation>
    </message>
    <message>
      <source>{v1} images of {v2} are missing, the first is {v3}.</source>
      <translation>{v2} 缺少 {v1} 幅图像，首先是 {v3}。</translation>
    </message>
    <message>
      <source>{v1} is no regular expression: {v2}</source>
      <translation>{v1} 不是正则表达式：{v2}</translation>
    </message>
    <message>
      <source>{v1}-bit pixels</source>
      <translation>{v1} 位像素</translation>
    </message>
  </context>
  <context>
    <name>core.camera_genicam</name>
    <message>
      <source>A program on {v1}</source>
      <translation>{v1} 上的程序</translation>
    </message>
    <message>
      <source>An image arrived {v1}.</source>
      <translation>有一幅图像到达时{v1}。</translation>
    </message>
    <message>
      <source>An image has size and format {v1}, which were not set.</source>
      <translation>有一幅图像的大小和格式为 {v1}，与设定不符。</translation>
    </message>
    <message>
      <source>An image has {v1} bytes instead of {v2}.</source>
      <translation>有一幅图像为 {v1} 字节，而非 {v2} 字节。</translation>
    </message>
    <message>
      <source>An image was exposed for {v1} µs instead of {v2} µs.</source>
      <translation>有一幅图像曝光了 {v1} µs，而非 {v2} µs。</translation>
    </message>
    <message>
      <source>An image with identifier {v1} arrived twice or late.</source>
      <translation>标识为 {v1} 的图像重复或迟到。</translation>
    </message>
    <message>
      <source>Another program</source>
      <translation>另一程序</translation>
    </message>
    <message>
      <source>Camera {v1} does not answer any more: {v2}.</source>
      <translation>相机 {v1} 不再应答：{v2}。</translation>
    </message>
    <message>
      <source>Camera {v1} does not support {v2} {v3}.</source>
      <translation>相机 {v1} 不支持 {v2} {v3}。</translation>
    </message>
    <message>
      <source>Camera {v1} has no feature {v2}.</source>
      <translation>相机 {v1} 没有功能 {v2}。</translation>
    </message>
    <message>
      <source>Camera {v1} has no pixel format for {v2} bit (setting: {v3}; the camera has {v4}).</source>
      <translation>相机 {v1} 没有 {v2} 位的像素格式（设置：{v3}；相机有 {v4}）。</translation>
    </message>
    <message>
      <source>Camera {v1} is not armed for software triggers.</source>
      <translation>相机 {v1} 未为软件触发就绪。</translation>
    </message>
    <message>
      <source>Camera {v1} {v2} within {v3} s.</source>
      <translation>相机 {v1} 在 {v3} s 内{v2}。</translation>
    </message>
    <message>
      <source>Camera {v1}: Aravis is only used on Linux and macOS.</source>
      <translation>相机 {v1}：Aravis 仅用于 Linux 和 macOS。</translation>
    </message>
    <message>
      <source>Camera {v1}: no camera with serial number {v2} was found (found: {v3}).</source>
      <translation>相机 {v1}：未找到序列号为 {v2} 的相机（找到：{v3}）。</translation>
    </message>
    <message>
      <source>Camera {v1}: packets have {v2} bytes and a delay of {v3} µs, instead of {v4} bytes and {v5} µs.</source>
      <translation>相机 {v1}：数据包为 {v2} 字节、间隔 {v3} µs，而非 {v4} 字节和 {v5} µs。</translation>
    </message>
    <message>
      <source>Camera {v1}: {v2}</source>
      <translation>相机 {v1}：{v2}</translation>
    </message>
    <message>
      <source>Camera {v1}: {v2} cannot be {v3} (possible: {v4}).</source>
      <translation>相机 {v1}：{v2} 不能为 {v3}（可用：{v4}）。</translation>
    </message>
    <message>
      <source>Camera {v1}: {v2} is {v3} after {v4} was written.</source>
      <translation>相机 {v1}：写入 {v4} 后 {v2} 为 {v3}。</translation>
    </message>
    <message>
      <source>Check cable, power and network, then connect the camera again.</source>
      <translation>请检查电缆、电源和网络，然后重新连接相机。</translation>
    </message>
    <message>
      <source>Check the setting named, and what this camera supports.</source>
      <translation>请检查所指设置，以及此相机支持的内容。</translation>
    </message>
    <message>
      <source>Check trigger and exposure; allow more time.</source>
      <translation>请检查触发和曝光；给出更多时间。</translation>
    </message>
    <message>
      <source>Choose a packet size and a delay that the camera supports.</source>
      <translation>请选择相机支持的数据包大小和间隔。</translation>
    </message>
    <message>
      <source>Choose a value that the camera keeps.</source>
      <translation>请选择相机能保持的值。</translation>
    </message>
    <message>
      <source>Choose one.</source>
      <translation>请选择一个。</translation>
    </message>
    <message>
      <source>Choose {v1}…{v2}.</source>
      <translation>请选择 {v1}…{v2}。</translation>
    </message>
    <message>
      <source>Close that program. If it crashed, wait a few seconds, then connect again.</source>
      <translation>请关闭该程序。若它已崩溃，请等几秒后重新连接。</translation>
    </message>
    <message>
      <source>Connect the camera again.</source>
      <translation>请重新连接相机。</translation>
    </message>
    <message>
      <source>Correct bit_depth in the rig description, or pixel_format in the camera's settings.</source>
      <translation>请更正测量系统描述中的 bit_depth，或相机设置中的 pixel_format。</translation>
    </message>
    <message>
      <source>Correct the serial number in the rig description, or check power, cable and the network address of the camera.</source>
      <translation>请更正测量系统描述中的序列号，或检查相机的电源、电缆和网络地址。</translation>
    </message>
    <message>
      <source>Image {v1} arrived after {v2} triggers.</source>
      <translation>图像 {v1} 在 {v2} 次触发之后到达。</translation>
    </message>
    <message>
      <source>On Debian and Ubuntu: apt-get install libaravis-0.8-0; on macOS: brew install aravis.</source>
      <translation>Debian 和 Ubuntu 上：apt-get install libaravis-0.8-0；macOS 上：brew install aravis。</translation>
    </message>
    <message>
      <source>Take it again. If it happens often: larger packets, a longer packet delay.</source>
      <translation>请重新拍摄。若经常发生：请用更大的数据包、更长的数据包间隔。</translation>
    </message>
    <message>
      <source>Take the whole sequence again.</source>
      <translation>请重新拍摄整个序列。</translation>
    </message>
    <message>
      <source>The library Aravis 0.8 is not installed</source>
      <translation>未安装库 Aravis 0.8</translation>
    </message>
    <message>
      <source>Update its firmware, or use another driver.</source>
      <translation>请更新其固件，或使用另一驱动。</translation>
    </message>
    <message>
      <source>Use the driver of the camera's manufacturer.</source>
      <translation>请使用相机厂商的驱动。</translation>
    </message>
    <message>
      <source>incomplete after a time-out</source>
      <translation>因超时而不完整</translation>
    </message>
    <message>
      <source>it has no feature {v1}</source>
      <translation>它没有特性 {v1}</translation>
    </message>
    <message>
      <source>it is no longer controlled by this program</source>
      <translation>它不再由本程序控制</translation>
    </message>
    <message>
      <source>its feature {v1} is no value</source>
      <translation>其特性 {v1} 不是值</translation>
    </message>
    <message>
      <source>its process does not answer in time</source>
      <translation>其进程没有及时应答</translation>
    </message>
    <message>
      <source>its process has closed the connection</source>
      <translation>其进程已关闭连接</translation>
    </message>
    <message>
      <source>of the wrong size</source>
      <translation>大小错误</translation>
    </message>
    <message>
      <source>sent no image</source>
      <translation>没有送出图像</translation>
    </message>
    <message>
      <source>was not ready for the next trigger</source>
      <translation>没有为下一次触发就绪</translation>
    </message>
    <message>
      <source>with packets of another image</source>
      <translation>混有另一图像的数据包</translation>
    </message>
    <message>
      <source>{v1} controls camera {v2} ({v3}).</source>
      <translation>{v1} 正在控制相机 {v2} ({v3})。</translation>
    </message>
    <message>
      <source>{v1} is not declared</source>
      <translation>{v1} 没有声明</translation>
    </message>
  </context>
  <context>
    <name>core.child_process</name>
    <message>
      <source>its process ended with code {v1}</source>
      <translation>其进程以代码 {v1} 结束</translation>
    </message>
    <message>
      <source>its process ended with code {v1} ({v2})</source>
      <translation>其进程以代码 {v1} 结束（{v2}）</translation>
    </message>
    <message>
      <source>its process was ended by signal {v1}, possibly for lack of memory</source>
      <translation>其进程被信号 {v1} 终止，可能因内存不足</translation>
    </message>
  </context>
  <context>
    <name>core.compiled</name>
    <message>
      <source>The environment variable {v1} is {v2}, but must be {v3} or {v4}.</source>
      <translation>环境变量 {v1} 为 {v2}，但必须为 {v3} 或 {v4}。</translation>
    </message>
    <message>
      <source>The length of a vector must be a constant.</source>
      <translation>向量的长度必须为常数。</translation>
    </message>
  </context>
  <context>
    <name>core.data</name>
    <message>
      <source>8 steps at {a} and {b} px</source>
      <translation>8 步相移，{a} 和 {b} px</translation>
    </message>
    <message>
      <source>A cloud in frame {v1} cannot be transformed by {v2}_from_{v3}.</source>
      <translation>坐标系{v1}中的点云不能用从{v3}到{v2}的变换来变换。</translation>
    </message>
    <message>
      <source>ChArUco board of {v1} × {v2} corners</source>
      <translation>{v1} × {v2} 角点的 ChArUco 板</translation>
    </message>
    <message>
      <source>Clouds in frames {v1} and {v2} cannot be merged.</source>
      <translation>坐标系 {v1} 与 {v2} 中的点云不能合并。</translation>
    </message>
    <message>
      <source>Customer</source>
      <translation>客户</translation>
    </message>
    <message>
      <source>Deviations by {v1} exceed the error model by {v2} mm (k = 1), which is added to U. Likely cause: {v3}.</source>
      <translation>按{v1}归类的偏差超出误差模型 {v2} mm (k = 1)，已计入 U。可能原因：{v3}。</translation>
    </message>
    <message>
      <source>Excluded as surroundings of the part, of all points: {v1}.</source>
      <translation>作为工件周围物体而去除，占所有点：{v1}。</translation>
    </message>
    <message>
      <source>Give robot pose, guide position and table angle.</source>
      <translation>请给出机器人位姿、导轨位置和转台角度。</translation>
    </message>
    <message>
      <source>Gray code: 4 steps at {a} px</source>
      <translation>格雷码：4 步相移，{a} px</translation>
    </message>
    <message>
      <source>ISO 2768-{v1} is defined for sizes from 0.5 to 4000 mm, not {v2} mm: enter the limits as numbers</source>
      <translation>ISO 2768-{v1} 的定义范围是 0.5 至 4000 mm，不包括 {v2} mm：请以数字输入极限</translation>
    </message>
    <message>
      <source>ISO 2768-{v1} states no tolerance for {v2} mm: enter the limits as numbers</source>
      <translation>ISO 2768-{v1} 对 {v2} mm 未规定公差：请以数字输入极限</translation>
    </message>
    <message>
      <source>Location</source>
      <translation>地点</translation>
    </message>
    <message>
      <source>Machine</source>
      <translation>测量机</translation>
    </message>
    <message>
      <source>Name one of {v1}, or a TOML file.</source>
      <translation>请指定 {v1} 之一，或一个 TOML 文件。</translation>
    </message>
    <message>
      <source>Name one of: {v1}.</source>
      <translation>请指定其一：{v1}。</translation>
    </message>
    <message>
      <source>No points were found where the part should stand on the table: none were excluded as its surroundings.</source>
      <translation>在工件应处于转台上的位置没有找到点：没有点作为环境被排除。</translation>
    </message>
    <message>
      <source>Part number</source>
      <translation>零件号</translation>
    </message>
    <message>
      <source>Part temperature</source>
      <translation>工件温度</translation>
    </message>
    <message>
      <source>Points of table, fixtures and background were kept, by choice.</source>
      <translation>按选择保留了转台、夹具和背景的点。</translation>
    </message>
    <message>
      <source>Relative humidity (%)</source>
      <translation>相对湿度 (%)</translation>
    </message>
    <message>
      <source>Revision</source>
      <translation>版次</translation>
    </message>
    <message>
      <source>Temperature (°C)</source>
      <translation>温度 (°C)</translation>
    </message>
    <message>
      <source>Temperature from</source>
      <translation>温度来源</translation>
    </message>
    <message>
      <source>The camera calibration contributes {v1} mm (k = 2) to the uncertainty of a length of {v2} mm in this volume, {v3} mm at worst.</source>
      <translation>相机标定对此体积内 {v2} mm 长度的不确定度贡献为 {v1} mm (k = 2)，最坏 {v3} mm。</translation>
    </message>
    <message>
      <source>The measurement agrees with its error model.</source>
      <translation>测量结果与其误差模型一致。</translation>
    </message>
    <message>
      <source>The read-back of an axis is missing.</source>
      <translation>缺少某轴的读回。</translation>
    </message>
    <message>
      <source>The reference camera {v1} is not among the calibrated cameras.</source>
      <translation>参考相机 {v1} 不在已标定的相机中。</translation>
    </message>
    <message>
      <source>The rotation axis is given in frame {v1}, not in the guide frame.</source>
      <translation>旋转轴以坐标系 {v1} 给出，而非导轨坐标系。</translation>
    </message>
    <message>
      <source>There is no world {v1}.</source>
      <translation>没有世界 {v1}。</translation>
    </message>
    <message>
      <source>Transform it to the guide frame.</source>
      <translation>请将其变换到导轨坐标系。</translation>
    </message>
    <message>
      <source>Transform them to one frame first.</source>
      <translation>请先将它们变换到同一坐标系。</translation>
    </message>
    <message>
      <source>Uncertainty of projected points by the calibration: up to {v1} px (k = 2).</source>
      <translation>标定引起的投影点不确定度：最大 {v1} px (k = 2)。</translation>
    </message>
    <message>
      <source>Use a transform from the frame of the cloud.</source>
      <translation>请使用从点云坐标系出发的变换。</translation>
    </message>
    <message>
      <source>`axis` has length 0</source>
      <translation>`axis` 的长度为 0</translation>
    </message>
    <message>
      <source>`count` is the number of copies that `{{k}}` in `of` runs over; it excludes `repeat`</source>
      <translation>`count` 是 `of` 中 `{{k}}` 所遍历的副本数；不能与 `repeat` 同时使用</translation>
    </message>
    <message>
      <source>`datum_letters`: {v1} is not a datum letter: use a capital such as A, or one twice, such as AA</source>
      <translation>`datum_letters`：{v1} 不是基准字母：请用大写字母，如 A，或重复两次，如 AA</translation>
    </message>
    <message>
      <source>`datum_material` names {v1} twice: remove one of them</source>
      <translation>`datum_material` 两次列出 {v1}：请去掉其中一个</translation>
    </message>
    <message>
      <source>`datum_material` names {v1}, which is not one of the `datums`: use a name of that list</source>
      <translation>`datum_material` 列出的 {v1} 不在 `datums` 中：请用该列表中的名称</translation>
    </message>
    <message>
      <source>`direction` has length 0</source>
      <translation>`direction` 的长度为 0</translation>
    </message>
    <message>
      <source>`facing` has length 0: give the direction that the surface faces</source>
      <translation>`facing` 的长度为 0：请给出表面朝向</translation>
    </message>
    <message>
      <source>`fold` uses all points: remove `features` and `regions`</source>
      <translation>`fold` 使用所有点：请去掉 `features` 和 `regions`</translation>
    </message>
    <message>
      <source>`grow` does not apply to {v1}</source>
      <translation>`grow` 不适用于 {v1}</translation>
    </message>
    <message>
      <source>`leading_mm` and `trailing_mm` are the same point</source>
      <translation>`leading_mm` 与 `trailing_mm` 是同一点</translation>
    </message>
    <message>
      <source>`lock` names an axis twice</source>
      <translation>`lock` 两次列出同一轴</translation>
    </message>
    <message>
      <source>`material_condition` and `size_limits_mm` need each other</source>
      <translation>`material_condition` 与 `size_limits_mm` 必须同时给出</translation>
    </message>
    <message>
      <source>`nominal` must be the certified length, above 0 mm</source>
      <translation>`nominal` 必须是证书长度，大于 0 mm</translation>
    </message>
    <message>
      <source>`nominal` of a {v1} cannot be negative: only a {v2} has a sign</source>
      <translation>{v1} 的 `nominal` 不能为负：只有 {v2} 带符号</translation>
    </message>
    <message>
      <source>`normal` has length 0</source>
      <translation>`normal` 的长度为 0</translation>
    </message>
    <message>
      <source>`per_row` and `row_step_mm` need each other</source>
      <translation>`per_row` 与 `row_step_mm` 必须同时给出</translation>
    </message>
    <message>
      <source>`tolerance` is a text, such as "±0.05", "+0.1/-0.05", "max 0.05" or "H7"</source>
      <translation>`tolerance` 是文本，例如 "±0.05"、"+0.1/-0.05"、"max 0.05" 或 "H7"</translation>
    </message>
    <message>
      <source>`tolerance` {v1} gives {v2} = {v3}, but {v4} is stated: remove one of them</source>
      <translation>`tolerance` {v1} 给出 {v2} = {v3}，而所述为 {v4}：请去掉其中一个</translation>
    </message>
    <message>
      <source>`zone_offset_mm` applies to a line_profile or surface_profile only: remove it</source>
      <translation>`zone_offset_mm` 只适用于 line_profile 或 surface_profile：请去掉它</translation>
    </message>
    <message>
      <source>`{v1}` has length 0</source>
      <translation>`{v1}` 的长度为 0</translation>
    </message>
    <message>
      <source>`{v1}` must not be 0 or parallel to `direction`</source>
      <translation>`{v1}` 不得为 0，也不得平行于 `direction`</translation>
    </message>
    <message>
      <source>`{{k}}` needs `count`, the number of copies</source>
      <translation>`{{k}}` 需要 `count`，即副本数</translation>
    </message>
    <message>
      <source>a `certificate` belongs to one length, such as a distance or a diameter: remove it here</source>
      <translation>`certificate` 只用于单个长度，例如距离或直径：请在此处删除</translation>
    </message>
    <message>
      <source>a blade_section needs either `plane_point_mm` and `plane_normal`, or `radius_mm`</source>
      <translation>blade_section 需要 `plane_point_mm` 和 `plane_normal`，或 `radius_mm`</translation>
    </message>
    <message>
      <source>a board of kind {v1} has no {v2}</source>
      <translation>{v1} 类型的标定板没有 {v2}</translation>
    </message>
    <message>
      <source>a board of kind {v1} needs {v2} = [columns, rows]</source>
      <translation>{v1} 类型的标定板需要 {v2} = [columns, rows]</translation>
    </message>
    <message>
      <source>a cone needs `half_angle_deg`</source>
      <translation>圆锥需要 `half_angle_deg`</translation>
    </message>
    <message>
      <source>a constructed {v1} needs {v2} features in `of`</source>
      <translation>构造的{v1}在 `of` 中需要 {v2} 个特征</translation>
    </message>
    <message>
      <source>a constructed {v1} {v2}</source>
      <translation>构造的{v1}{v2}</translation>
    </message>
    <message>
      <source>a direction of `along` has length 0</source>
      <translation>`along` 的某个方向长度为 0</translation>
    </message>
    <message>
      <source>a film on glass, up to 50 ppm off</source>
      <translation>玻璃上的薄膜，偏差最多 50 ppm</translation>
    </message>
    <message>
      <source>a grid needs `step_mm`, the displacement within a row</source>
      <translation>网格需要 `step_mm`，即行内的位移</translation>
    </message>
    <message>
      <source>a line lies on one face: give one of `normals`</source>
      <translation>直线位于一个面上：请给出 `normals` 中的一个</translation>
    </message>
    <message>
      <source>a line_profile needs `section`, its section plane</source>
      <translation>line_profile 需要 `section`，即其截面</translation>
    </message>
    <message>
      <source>a material condition applies to a position only: remove it, or use kind = position</source>
      <translation>实体要求只适用于位置度：请去掉它，或用 kind = position</translation>
    </message>
    <message>
      <source>a nominal needs `point_mm`; remove direction and sizes of a feature without nominal position</source>
      <translation>名义值需要 `point_mm`；没有名义位置的特征请去掉方向和尺寸</translation>
    </message>
    <message>
      <source>a pattern is rotated by `angle_deg` or displaced by `step_mm`: remove one of them</source>
      <translation>阵列按 `angle_deg` 旋转或按 `step_mm` 平移：请去掉其中一个</translation>
    </message>
    <message>
      <source>a printed board, ± 0.1 mm on 180 mm</source>
      <translation>打印的标定板，180 mm 上 ± 0.1 mm</translation>
    </message>
    <message>
      <source>a reference point has `along` or `lock`: remove one of them</source>
      <translation>参考点只能有 `along` 或 `lock`：请去掉其中一个</translation>
    </message>
    <message>
      <source>a region needs at least one of x_mm, y_mm, z_mm, radial_mm</source>
      <translation>区域至少需要 x_mm、y_mm、z_mm、radial_mm 之一</translation>
    </message>
    <message>
      <source>a slot is longer than wide; otherwise use a circle</source>
      <translation>槽的长度大于宽度；否则请用圆</translation>
    </message>
    <message>
      <source>a slot needs `along`, its long direction, `length_mm` and `width_mm`</source>
      <translation>槽需要 `along`（其长度方向）、`length_mm` 和 `width_mm`</translation>
    </message>
    <message>
      <source>a surface_point, which is a patch around its nominal</source>
      <translation>surface_point，即其名义位置周围的一小片</translation>
    </message>
    <message>
      <source>a table [devices.NAME] is missing for {v1}</source>
      <translation>缺少 {v1} 的表 [devices.NAME]</translation>
    </message>
    <message>
      <source>a {v1} has no datums</source>
      <translation>{v1} 没有基准</translation>
    </message>
    <message>
      <source>a {v1} has one datum</source>
      <translation>{v1} 只有一个基准</translation>
    </message>
    <message>
      <source>a {v1} is the width of a tolerance zone: its nominal is 0, `upper_tolerance` the width allowed</source>
      <translation>{v1} 是公差带的宽度：其名义值为 0，`upper_tolerance` 为允许的宽度</translation>
    </message>
    <message>
      <source>a {v1} needs `datums`</source>
      <translation>{v1} 需要 `datums`</translation>
    </message>
    <message>
      <source>a {v1} needs `direction`</source>
      <translation>{v1}需要 `direction`</translation>
    </message>
    <message>
      <source>a {v1} needs `length_mm` and `normals`, the outward normals of its faces</source>
      <translation>{v1}需要 `length_mm` 和 `normals`，即其各面的外法线</translation>
    </message>
    <message>
      <source>a {v1} needs `point_mm`, or `grow` with a seed</source>
      <translation>{v1}需要 `point_mm`，或带种子的 `grow`</translation>
    </message>
    <message>
      <source>a {v1} needs `radius_mm`</source>
      <translation>{v1}需要 `radius_mm`</translation>
    </message>
    <message>
      <source>air temperature in °C</source>
      <translation>空气温度，单位 °C</translation>
    </message>
    <message>
      <source>an edge needs the `normals` of both faces; a free edge has one, and needs `loss_mm`: fringe window and blur end the points before the material ends</source>
      <translation>边需要两个面的 `normals`；自由边只有一个，并需要 `loss_mm`：由于条纹窗口和模糊，点在材料结束之前就结束</translation>
    </message>
    <message>
      <source>an exact board</source>
      <translation>精确的标定板</translation>
    </message>
    <message>
      <source>an expansion of {v1} ppm/K is not between 0 and {v2} ppm/K</source>
      <translation>热膨胀系数 {v1} ppm/K 不在 0 与 {v2} ppm/K 之间</translation>
    </message>
    <message>
      <source>an uncertainty of {v1} K is not between 0 and {v2} K</source>
      <translation>不确定度 {v1} K 不在 0 与 {v2} K 之间</translation>
    </message>
    <message>
      <source>as its nominal is oriented</source>
      <translation>按其名义模型的姿态</translation>
    </message>
    <message>
      <source>at least {v1}</source>
      <translation>至少 {v1}</translation>
    </message>
    <message>
      <source>at {v1} ± {v2} °C, not corrected</source>
      <translation>温度 {v1} ± {v2} °C，未修正</translation>
    </message>
    <message>
      <source>best-fit, none, local:FEATURE,…, cyclic:COUNT, 3-2-1:PLANE,LINE,POINT, rps:POINT,POINT,POINT,… or datums:A,B,C</source>
      <translation>best-fit、none、local:FEATURE,…、cyclic:COUNT、3-2-1:PLANE,LINE,POINT、rps:POINT,POINT,POINT,… 或 datums:A,B,C</translation>
    </message>
    <message>
      <source>board of {v1} × {v2} corners</source>
      <translation>{v1} × {v2} 角点的标定板</translation>
    </message>
    <message>
      <source>certificate {v1}</source>
      <translation>证书 {v1}</translation>
    </message>
    <message>
      <source>certified_mm has {v1} marks, the {v2} has {v3}</source>
      <translation>certified_mm 有 {v1} 个标志点，{v2}有 {v3} 个</translation>
    </message>
    <message>
      <source>chrome on glass or ceramic, ± 8 ppm</source>
      <translation>玻璃或陶瓷上镀铬，± 8 ppm</translation>
    </message>
    <message>
      <source>circles</source>
      <translation>circles</translation>
    </message>
    <message>
      <source>circles of {v1} mm are too close: at most {v2} mm at this spacing</source>
      <translation>{v1} mm 的圆点过密：此间距下最大为 {v2} mm</translation>
    </message>
    <message>
      <source>complementary Gray code: 4 steps at {a} px</source>
      <translation>互补格雷码：4 步相移，{a} px</translation>
    </message>
    <message>
      <source>complementary Gray code: 8 steps at {a} px</source>
      <translation>互补格雷码：8 步相移，{a} px</translation>
    </message>
    <message>
      <source>datum {v1} names feature {v2}, which is not defined</source>
      <translation>基准 {v1} 引用的特征 {v2} 没有定义</translation>
    </message>
    <message>
      <source>dimension {v1} names the alignment {v2}, which is not defined</source>
      <translation>尺寸 {v1} 引用的对齐 {v2} 没有定义</translation>
    </message>
    <message>
      <source>dimension {v1} needs feature {v2}, which is not defined</source>
      <translation>尺寸 {v1} 需要特征 {v2}，它没有定义</translation>
    </message>
    <message>
      <source>dimension {v1}: {v2} is a free_form, which allows only a surface_profile or line_profile</source>
      <translation>尺寸 {v1}：{v2} 是 free_form，只允许 surface_profile 或 line_profile</translation>
    </message>
    <message>
      <source>dimension {v1}: {v2} {v3}; a {v4} cannot be evaluated on it</source>
      <translation>尺寸 {v1}：{v2} {v3}；不能在其上评定 {v4}</translation>
    </message>
    <message>
      <source>displaced_mm has {v1} marks, the {v2} has {v3}</source>
      <translation>displaced_mm 有 {v1} 个标志点，{v2}有 {v3} 个</translation>
    </message>
    <message>
      <source>error motions of the guide: {v1}</source>
      <translation>导轨的运动误差：{v1}</translation>
    </message>
    <message>
      <source>error motions of the table: {v1}</source>
      <translation>转台的运动误差：{v1}</translation>
    </message>
    <message>
      <source>exposures must be positive and run from long to short without repeats</source>
      <translation>曝光必须为正，从长到短且不重复</translation>
    </message>
    <message>
      <source>feature {v1} has two datum letters, {v2} and {v3}: remove one of them</source>
      <translation>特征 {v1} 有两个基准字母 {v2} 和 {v3}：请去掉其中一个</translation>
    </message>
    <message>
      <source>feature {v1} is a common datum, which has the letters of its features, not {v2}</source>
      <translation>特征 {v1} 是公共基准，其字母为各组成特征的字母，不是 {v2}</translation>
    </message>
    <message>
      <source>feature {v1} is constructed from {v2}, a free_form: use a plane, an axis or a centre</source>
      <translation>特征 {v1} 由 free_form {v2} 构造：请用平面、轴线或中心</translation>
    </message>
    <message>
      <source>feature {v1} is constructed from {v2}, which is not defined before it</source>
      <translation>特征 {v1} 由 {v2} 构造，而后者没有在它之前定义</translation>
    </message>
    <message>
      <source>feature {v1}: its pattern must be about the z axis; other patterns apply to measured shapes</source>
      <translation>特征 {v1}：其阵列必须绕 z 轴；其他阵列适用于测量的形状</translation>
    </message>
    <message>
      <source>grid of {v1} × {v2} circles</source>
      <translation>{v1} × {v2} 圆点阵列</translation>
    </message>
    <message>
      <source>groups of vertical fringes must come before those of horizontal ones</source>
      <translation>竖直条纹的组必须在水平条纹的组之前</translation>
    </message>
    <message>
      <source>has no `distance_mm`</source>
      <translation>没有 `distance_mm`</translation>
    </message>
    <message>
      <source>hierarchical: 4 steps, each pitch half of the one before, from {a} px</source>
      <translation>分层：4 步相移，每个间距为前一个的一半，从 {a} px 开始</translation>
    </message>
    <message>
      <source>horizontal fringes need projector_rows</source>
      <translation>水平条纹需要 projector_rows</translation>
    </message>
    <message>
      <source>in the middle of the table, {v1}</source>
      <translation>在转台中央，{v1}</translation>
    </message>
    <message>
      <source>is not a known field</source>
      <translation>不是已知字段</translation>
    </message>
    <message>
      <source>kind {v1} needs `nominal`</source>
      <translation>类型 {v1} 需要 `nominal`</translation>
    </message>
    <message>
      <source>kind {v1} needs two different features, {v2} is named twice</source>
      <translation>类型 {v1} 需要两个不同的特征，而 {v2} 出现了两次</translation>
    </message>
    <message>
      <source>kind {v1} needs {v2}</source>
      <translation>类型 {v1} 需要{v2}</translation>
    </message>
    <message>
      <source>legacy_pattern applies only to an even number of rows of squares (an odd number of rows of corners)</source>
      <translation>legacy_pattern 只适用于方格行数为偶数（角点行数为奇数）的情况</translation>
    </message>
    <message>
      <source>loop closure over {v1} views around the part: {v2} mm and {v3}° (expected: {v4} mm)</source>
      <translation>绕工件 {v1} 个视图的闭环：{v2} mm 和 {v3}°（预期：{v4} mm）</translation>
    </message>
    <message>
      <source>low_mm must be below high_mm in x, y and z</source>
      <translation>low_mm 在 x、y、z 上都必须小于 high_mm</translation>
    </message>
    <message>
      <source>lower_tolerance is greater than upper_tolerance</source>
      <translation>lower_tolerance 大于 upper_tolerance</translation>
    </message>
    <message>
      <source>markers of {v1} mm do not fit into squares of {v2} mm</source>
      <translation>{v1} mm 的标记放不进 {v2} mm 的方格</translation>
    </message>
    <message>
      <source>measured at {v1} ± {v2} °C, corrected to {v3} °C with {v4} ppm/K</source>
      <translation>在 {v1} ± {v2} °C 下测量，以 {v4} ppm/K 修正到 {v3} °C</translation>
    </message>
    <message>
      <source>measuring machine; the name of the rig where it is empty</source>
      <translation>测量机；为空时用测量系统的名称</translation>
    </message>
    <message>
      <source>must be the name of a file in the template's folder</source>
      <translation>必须是模板文件夹中的文件名</translation>
    </message>
    <message>
      <source>name either one driver for the whole rig, or a table [devices.NAME] for each device</source>
      <translation>请为整个测量系统指定一个驱动，或为每台设备给出表 [devices.NAME]</translation>
    </message>
    <message>
      <source>name the groups of {v1} {v2}</source>
      <translation>请将 {v1} 的组命名为 {v2}</translation>
    </message>
    <message>
      <source>name the groups of {v1} {v2}, not {v3}</source>
      <translation>请将 {v1} 的组命名为 {v2}，而非 {v3}</translation>
    </message>
    <message>
      <source>needs `distance_mm`</source>
      <translation>需要 `distance_mm`</translation>
    </message>
    <message>
      <source>neither rig nor cameras is given: name a rig description, or the cameras.json of calibrated cameras</source>
      <translation>既没有 rig 也没有 cameras：请指定测量系统描述，或已标定相机的 cameras.json</translation>
    </message>
    <message>
      <source>of the part drawing</source>
      <translation>零件图的版次</translation>
    </message>
    <message>
      <source>of the part in °C with its uncertainty (k = 2), such as 23±0.5: lengths are corrected to 20 °C</source>
      <translation>工件的温度，单位 °C，含其不确定度 (k = 2)，例如 23±0.5：长度将修正到 20 °C</translation>
    </message>
    <message>
      <source>of the part, such as steel, or its expansion, such as 11.5±0.6 ppm/K</source>
      <translation>工件的材料，例如 steel，或其热膨胀系数，例如 11.5±0.6 ppm/K</translation>
    </message>
    <message>
      <source>paper: 4 steps at {a} and {b} px</source>
      <translation>论文：4 步相移，{a} 和 {b} px</translation>
    </message>
    <message>
      <source>radial ± {v1}, axial ± {v2}, tilt ± {v3}″</source>
      <translation>径向 ± {v1}，轴向 ± {v2}，倾斜 ± {v3}″</translation>
    </message>
    <message>
      <source>relative humidity of the air</source>
      <translation>空气的相对湿度</translation>
    </message>
    <message>
      <source>several viewpoints have the id {v1} (capital and small letters count as equal)</source>
      <translation>多个视点的 ID 为 {v1}（不区分大小写）</translation>
    </message>
    <message>
      <source>straightness ± {v1}, pitch, yaw and roll ± {v2}″</source>
      <translation>直线度 ± {v1}，俯仰、偏摆和滚转 ± {v2}″</translation>
    </message>
    <message>
      <source>the alignment {v1}</source>
      <translation>对齐 {v1}</translation>
    </message>
    <message>
      <source>the board</source>
      <translation>标定板</translation>
    </message>
    <message>
      <source>the board needs {v1} markers, dictionary {v2} has {v3}</source>
      <translation>该标定板需要 {v1} 个标记，字典 {v2} 有 {v3} 个</translation>
    </message>
    <message>
      <source>the class {v1} has neither a number nor a certified scale</source>
      <translation>等级 {v1} 既无编号也无检定比例</translation>
    </message>
    <message>
      <source>the expansion of {v1} is not known: choose one of {v2}, or state it, such as 11.5±0.6 ppm/K</source>
      <translation>{v1} 的热膨胀系数未知：请从 {v2} 中选择，或直接给出，例如 11.5±0.6 ppm/K</translation>
    </message>
    <message>
      <source>the faces of an edge must not be parallel</source>
      <translation>边的两个面不得平行</translation>
    </message>
    <message>
      <source>the lower end of range_mm is not below the upper one</source>
      <translation>range_mm 的下限不低于上限</translation>
    </message>
    <message>
      <source>the lower end of tolerance_mm is above the upper one</source>
      <translation>tolerance_mm 的下限高于上限</translation>
    </message>
    <message>
      <source>the method spheres needs sphere_diameter_mm</source>
      <translation>方法 spheres 需要 sphere_diameter_mm</translation>
    </message>
    <message>
      <source>the name {v1} belongs to two devices</source>
      <translation>名称 {v1} 属于两台设备</translation>
    </message>
    <message>
      <source>the names of the set-ups are not unique</source>
      <translation>装夹的名称不唯一</translation>
    </message>
    <message>
      <source>the plan has no viewpoints</source>
      <translation>计划中没有视点</translation>
    </message>
    <message>
      <source>the quaternion (w, x, y, z) must have length 1</source>
      <translation>四元数 (w, x, y, z) 的长度必须为 1</translation>
    </message>
    <message>
      <source>the ranges of a region must run from the smaller to the greater value</source>
      <translation>区域的范围必须从小到大</translation>
    </message>
    <message>
      <source>the reference camera {v1} is none of the cameras ({v2})</source>
      <translation>参考相机 {v1} 不在相机之列（{v2}）</translation>
    </message>
    <message>
      <source>the rig has no device {v1}</source>
      <translation>测量系统没有设备 {v1}</translation>
    </message>
    <message>
      <source>there are board views, but no [board]</source>
      <translation>有标定板视图，但没有 [board]</translation>
    </message>
    <message>
      <source>there is neither a [[board_view]] nor a [[viewpoint]]</source>
      <translation>既没有 [[board_view]] 也没有 [[viewpoint]]</translation>
    </message>
    <message>
      <source>there is no dictionary {v1}; there are {v2}</source>
      <translation>没有字典 {v1}；可用：{v2}</translation>
    </message>
    <message>
      <source>there is no pattern set {v1}, only {v2}</source>
      <translation>没有图案集 {v1}，只有 {v2}</translation>
    </message>
    <message>
      <source>they move the board by {v1} rms between the views of the calibration; positions are corrected for them</source>
      <translation>在标定的各视图之间它们使标定板移动 {v1} rms；位置已作修正</translation>
    </message>
    <message>
      <source>three close pitches: 3 steps at {a}, {b} and {c} px</source>
      <translation>三个相近间距：3 步相移，{a}、{b} 和 {c} px</translation>
    </message>
    <message>
      <source>three close pitches: 4 steps at {a}, {b} and {c} px</source>
      <translation>三个相近间距：4 步相移，{a}、{b} 和 {c} px</translation>
    </message>
    <message>
      <source>three close pitches: 8 steps at {a}, {b} and {c} px</source>
      <translation>三个相近间距：8 步相移，{a}、{b} 和 {c} px</translation>
    </message>
    <message>
      <source>three wide pitches: 4 steps at {a}, {b} and {c} px</source>
      <translation>三个宽间距：4 步相移，{a}、{b} 和 {c} px</translation>
    </message>
    <message>
      <source>three wide pitches: 8, 4 and 4 steps at {a}, {b} and {c} px</source>
      <translation>三个宽间距：8、4 和 4 步相移，{a}、{b} 和 {c} px</translation>
    </message>
    <message>
      <source>turned by {v1}° about x, y and z</source>
      <translation>绕 x、y、z 转动 {v1}°</translation>
    </message>
    <message>
      <source>two alignments have the same name</source>
      <translation>两个对齐有相同的名称</translation>
    </message>
    <message>
      <source>two dimensions have the same name</source>
      <translation>两个尺寸有相同的名称</translation>
    </message>
    <message>
      <source>two features have the name {v1}</source>
      <translation>两个特征都名为 {v1}</translation>
    </message>
    <message>
      <source>two viewpoints have the same id {v1}</source>
      <translation>两个视点的 ID 同为 {v1}</translation>
    </message>
    <message>
      <source>view {v1} is both used and refused</source>
      <translation>视图 {v1} 既被采用又被拒绝</translation>
    </message>
    <message>
      <source>who or what measured the temperature</source>
      <translation>由何人或何种仪器测量温度</translation>
    </message>
    <message>
      <source>with a material condition the mean of several positions is meaningless: use `statistic = "max"`</source>
      <translation>有实体要求时，多个位置度的平均值没有意义：请用 `statistic = "max"`</translation>
    </message>
    <message>
      <source>with the origin of its nominal at ({v1}) mm, {v2}</source>
      <translation>名义模型的原点在 ({v1}) mm，{v2}</translation>
    </message>
    <message>
      <source>{share} background</source>
      <translation>{share} 为背景</translation>
    </message>
    <message>
      <source>{share} fixtures of the rig description</source>
      <translation>{share} 为设备描述中的夹具</translation>
    </message>
    <message>
      <source>{share} others far from the nominal, such as clamps</source>
      <translation>{share} 为远离名义模型的其他点，如压板</translation>
    </message>
    <message>
      <source>{share} the table's top, and all within {above} mm above it</source>
      <translation>{share} 为转台台面及其上方 {above} mm 以内的所有点</translation>
    </message>
    <message>
      <source>{v1} applies to linear sizes only: enter the limits as numbers, such as ±0.5</source>
      <translation>{v1} 只适用于线性尺寸：请以数字输入极限，如 ±0.5</translation>
    </message>
    <message>
      <source>{v1} is defined for sizes up to {v2} mm, not {v3} mm: enter the limits as numbers</source>
      <translation>{v1} 的定义范围为 {v2} mm 以下，不包括 {v3} mm：请以数字输入极限</translation>
    </message>
    <message>
      <source>{v1} is no name of a folder: use letters, digits, '_', '-' and '.', at most 64, and no '.' at either end</source>
      <translation>{v1} 不能作文件夹名：请用字母、数字、“_”、“-”和“.”，最多 64 个，且两端不能是“.”</translation>
    </message>
    <message>
      <source>{v1} is not a field; fields are {v2}</source>
      <translation>{v1} 不是字段；字段有 {v2}</translation>
    </message>
    <message>
      <source>{v1} is not a regular expression: {v2}</source>
      <translation>{v1} 不是正则表达式：{v2}</translation>
    </message>
    <message>
      <source>{v1} is not a temperature in °C, such as 23±0.5</source>
      <translation>{v1} 不是以 °C 表示的温度，例如 23±0.5</translation>
    </message>
    <message>
      <source>{v1} is not a tolerance: enter {v2}</source>
      <translation>{v1} 不是公差：请输入 {v2}</translation>
    </message>
    <message>
      <source>{v1} is not an alignment: give {v2}</source>
      <translation>{v1} 不是对齐方式：请给出 {v2}</translation>
    </message>
    <message>
      <source>{v1} is not available: the grades are IT{v2} to IT{v3}; enter the limits as numbers</source>
      <translation>没有 {v1}：等级为 IT{v2} 至 IT{v3}；请以数字输入极限</translation>
    </message>
    <message>
      <source>{v1} is not the width of a tolerance zone: enter one number, such as max 0.05</source>
      <translation>{v1} 不是公差带的宽度：请输入一个数字，如 max 0.05</translation>
    </message>
    <message>
      <source>{v1} is one number: enter ±{v2}, or both limits, such as +{v3}/0</source>
      <translation>{v1} 是单个数字：请输入 ±{v2}，或两个极限，如 +{v3}/0</translation>
    </message>
    <message>
      <source>{v1} mm found, {v2} mm expected</source>
      <translation>实测 {v1} mm，预期 {v2} mm</translation>
    </message>
    <message>
      <source>{v1} must run from the smaller to the greater diameter</source>
      <translation>{v1} 必须从小直径到大直径</translation>
    </message>
    <message>
      <source>{v1} must run from the smaller to the greater value</source>
      <translation>{v1} 必须从小到大</translation>
    </message>
    <message>
      <source>{v1} needs feature {v2}, which is not defined</source>
      <translation>{v1} 需要特征 {v2}，它没有定义</translation>
    </message>
    <message>
      <source>{v1} uses {v2}, a free_form: use another feature, or a region of the best fit</source>
      <translation>{v1} 使用 free_form {v2}：请用其他特征，或最佳拟合的区域</translation>
    </message>
    <message>
      <source>{v1} °C is not between {v2} and {v3} °C</source>
      <translation>{v1} °C 不在 {v2} 与 {v3} °C 之间</translation>
    </message>
    <message>
      <source>{v1}, board at a temperature that was not measured</source>
      <translation>{v1}，标定板温度未测量</translation>
    </message>
    <message>
      <source>{v1}, board at {v2} ± {v3} °C</source>
      <translation>{v1}，标定板温度 {v2} ± {v3} °C</translation>
    </message>
    <message>
      <source>{v1}, both directions</source>
      <translation>{v1}，两个方向</translation>
    </message>
    <message>
      <source>{v1}: a tolerance of zero width cannot be verified; enter a number above 0</source>
      <translation>{v1}：宽度为零的公差无法验证；请输入大于 0 的数字</translation>
    </message>
    <message>
      <source>{v1}: both limits are equal; give a range</source>
      <translation>{v1}：两个极限相等；请给出范围</translation>
    </message>
    <message>
      <source>{v1}: explained</source>
      <translation>{v1}：可解释</translation>
    </message>
    <message>
      <source>{v1}: give both limits a sign, such as +{v2}</source>
      <translation>{v1}：请为两个极限都加上符号，如 +{v2}</translation>
    </message>
    <message>
      <source>{v1}: max applies to the width of a tolerance zone; for a size enter both limits, such as 0/-0.2</source>
      <translation>{v1}：max 用于公差带的宽度；对于尺寸请输入两个极限，如 0/-0.2</translation>
    </message>
    <message>
      <source>{v1}: the classes of ISO 2768-1 are f, m, c and v</source>
      <translation>{v1}：ISO 2768-1 的等级为 f、m、c 和 v</translation>
    </message>
    <message>
      <source>{v1}: with ISO 22081 the drawing states the values: enter them, such as ±0.3</source>
      <translation>{v1}：按 ISO 22081，数值由图样给出：请输入这些数值，如 ±0.3</translation>
    </message>
    <message>
      <source>{v1}: {v2} is no path relative to this file</source>
      <translation>{v1}：{v2} 不是相对于此文件的路径</translation>
    </message>
    <message>
      <source>{v1}: {v2} is the class of geometrical tolerances; for a size enter 2768-{v3}</source>
      <translation>{v1}：{v2} 是几何公差的等级；对于尺寸请输入 2768-{v3}</translation>
    </message>
    <message>
      <source>{v1}: {v2} mm not explained; likely cause: {v3}</source>
      <translation>{v1}：{v2} mm 无法解释；可能原因：{v3}</translation>
    </message>
    <message>
      <source>{v1}{v2} is not available: the classes are {v3}; enter the limits as numbers</source>
      <translation>没有 {v1}{v2}：可用的公差带代号为 {v3}；请以数字输入极限</translation>
    </message>
    <message>
      <source>±0.1, +0.1/-0.05, 0/-0.2, H7, 2768-m, or nothing for no verdict</source>
      <translation>±0.1、+0.1/-0.05、0/-0.2、H7、2768-m，或留空而不判定</translation>
    </message>
  </context>
  <context>
    <name>core.devices</name>
    <message>
      <source>Add a table [links.{v1}] to the rig description.</source>
      <translation>请在测量系统描述中添加表 [links.{v1}]。</translation>
    </message>
    <message>
      <source>An exposure of {v1} µs is not a whole number of the frames of {v2} ({v3} µs each).</source>
      <translation>{v1} µs 的曝光不是 {v2} 帧的整数倍（每帧 {v3} µs）。</translation>
    </message>
    <message>
      <source>Camera {v1} delivered image {v2} where image {v3} was due: its images cannot be assigned to patterns.</source>
      <translation>应为图像 {v3} 时，相机 {v1} 送出了图像 {v2}：其图像无法与图案对应。</translation>
    </message>
    <message>
      <source>Camera {v1} ends the exposure of its rows one after the other (global reset), and {v2} stays lit meanwhile: the last row would get {v3} ms more light.</source>
      <translation>相机 {v1} 逐行结束曝光（全局复位），而此时{v2}仍亮：最后一行会多得 {v3} ms 的光。</translation>
    </message>
    <message>
      <source>Camera {v1} exposes its rows one after the other over {v2} ms, and {v3} is lit during the exposure of {v4} ms only: no instant of light is common to all rows.</source>
      <translation>相机 {v1} 在 {v2} ms 内逐行曝光，而{v3}只在 {v4} ms 曝光期间点亮：没有所有行共同的照明时刻。</translation>
    </message>
    <message>
      <source>Camera {v1} set {v2} µs instead of the requested {v3} µs.</source>
      <translation>相机 {v1} 设置了 {v2} µs，而非要求的 {v3} µs。</translation>
    </message>
    <message>
      <source>Camera {v1}: {v2}.</source>
      <translation>相机 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>Cameras {v1} together send at {v2} % of link {v3} ({v4} Gbit/s) and lose packets: set an inter-packet delay of {v5} ticks in each.</source>
      <translation>相机 {v1} 合计占用连接 {v3}（{v4} Gbit/s）的 {v2} %，并丢失数据包：请将每台的数据包间隔设为 {v5} 个时钟周期。</translation>
    </message>
    <message>
      <source>Change the id in {v1}.</source>
      <translation>请更改 {v1} 中的 ID。</translation>
    </message>
    <message>
      <source>Check its settings, trigger line and cable.</source>
      <translation>请检查其设置、触发线和电缆。</translation>
    </message>
    <message>
      <source>Check its trigger line, its cable and the load of its link.</source>
      <translation>请检查其触发线、电缆和连接的负载。</translation>
    </message>
    <message>
      <source>Check that the device is on and connected; if it is, report the error to the author of the driver.</source>
      <translation>请检查设备已开启并连接；若是，请将错误报告给驱动作者。</translation>
    </message>
    <message>
      <source>Check the device; allow more time if it is sound.</source>
      <translation>请检查设备；若设备正常，请给出更多时间。</translation>
    </message>
    <message>
      <source>Check the file and its permissions.</source>
      <translation>请检查该文件及其权限。</translation>
    </message>
    <message>
      <source>Check the permissions of this folder.</source>
      <translation>请检查此文件夹的权限。</translation>
    </message>
    <message>
      <source>Check the trigger line; lengthen the period if the cameras were still busy.</source>
      <translation>请检查触发线；若相机仍忙，请加大周期。</translation>
    </message>
    <message>
      <source>Choose an exposure that the camera supports, and switch its automatic exposure off.</source>
      <translation>请选择相机支持的曝光，并关闭其自动曝光。</translation>
    </message>
    <message>
      <source>Choose {v1} or {v2} µs; the grey levels are only right over whole frames.</source>
      <translation>请选择 {v1} 或 {v2} µs；只有整数帧的灰度才正确。</translation>
    </message>
    <message>
      <source>Correct it in the rig description.</source>
      <translation>请在测量系统描述中更正。</translation>
    </message>
    <message>
      <source>Correct the driver's id, or add its folder to plugins.</source>
      <translation>请更正驱动的 ID，或将其文件夹加入 plugins。</translation>
    </message>
    <message>
      <source>Correct the line named.</source>
      <translation>请更正所指的行。</translation>
    </message>
    <message>
      <source>Correct this field.</source>
      <translation>请更正此字段。</translation>
    </message>
    <message>
      <source>Correct {v1}.</source>
      <translation>请更正 {v1}。</translation>
    </message>
    <message>
      <source>Derive it from measureapp.data.model.Model.</source>
      <translation>请从 measureapp.data.model.Model 派生。</translation>
    </message>
    <message>
      <source>Disconnect the rig there first. Projects can be opened, processed and reported here meanwhile, without the rig.</source>
      <translation>请先在那里断开测量系统。其间可在此不用测量系统打开、处理项目和出报告。</translation>
    </message>
    <message>
      <source>Give drivers of different kinds links of their own.</source>
      <translation>请给不同类型的驱动各自的连接。</translation>
    </message>
    <message>
      <source>If you trust it, run: measureapp plugins --folder {v1} --allow {v2}</source>
      <translation>若信任它，请运行：measureapp plugins --folder {v1} --allow {v2}</translation>
    </message>
    <message>
      <source>Inspect them, then allow the driver again.</source>
      <translation>请先查看这些文件，再允许该驱动。</translation>
    </message>
    <message>
      <source>Install it, or put {v1}.py into {v2} and import it with a leading dot.</source>
      <translation>请安装它，或将 {v1}.py 放入 {v2}，并以前导点导入。</translation>
    </message>
    <message>
      <source>Link {v1} is a {v2}, and a driver needs a {v3}.</source>
      <translation>连接 {v1} 是 {v2}，而驱动需要 {v3}。</translation>
    </message>
    <message>
      <source>Name a driver of a {v1} in the rig description (available: {v2}).</source>
      <translation>请在测量系统描述中为{v1}指定驱动（可用：{v2}）。</translation>
    </message>
    <message>
      <source>No serial adapter with {v1} was found (adapters here: {v2}).</source>
      <translation>未找到{v1}的串行适配器（此处有：{v2}）。</translation>
    </message>
    <message>
      <source>On link {v1} an image is transferred in {v2} ms of the {v3} ms between two images, which leaves less than {v4} % for packets that are sent again: use larger packets or a longer exposure.</source>
      <translation>在连接 {v1} 上，传输一幅图像需要两幅图像间 {v3} ms 中的 {v2} ms，留给重发数据包的不足 {v4} %：请用更大的数据包或更长的曝光。</translation>
    </message>
    <message>
      <source>On link {v1} an image is transferred in {v2} ms, but the next one may be exposed after {v3} ms: the sequence slows down to {v4} ms an image; use larger packets, fewer bits or a second link.</source>
      <translation>在连接 {v1} 上，传输一幅图像需要 {v2} ms，而下一幅可在 {v3} ms 后曝光：序列减慢到每幅 {v4} ms；请用更大的数据包、更少的位数或第二条连接。</translation>
    </message>
    <message>
      <source>Plug it in, or set port, host or usb_serial in [links].</source>
      <translation>请插上它，或在 [links] 中设置 port、host 或 usb_serial。</translation>
    </message>
    <message>
      <source>Plugin {v1} cannot be imported: {v2}: {v3}.</source>
      <translation>无法导入插件 {v1}：{v2}：{v3}。</translation>
    </message>
    <message>
      <source>Plugin {v1} has no {v2} {v3} in {v4}.py.</source>
      <translation>插件 {v1} 的 {v4}.py 中没有 {v2} {v3}。</translation>
    </message>
    <message>
      <source>Plugin {v1} needs the module {v2}, which is missing.</source>
      <translation>插件 {v1} 缺少所需的模块 {v2}。</translation>
    </message>
    <message>
      <source>Plugin {v1}: {v2}</source>
      <translation>插件 {v1}：{v2}</translation>
    </message>
    <message>
      <source>Plugin {v1}: {v2} is not a model of settings.</source>
      <translation>插件 {v1}：{v2} 不是设置的模型。</translation>
    </message>
    <message>
      <source>Process its project with `measureapp process PROJECT`, or name the description of a connected rig.</source>
      <translation>请用 `measureapp process PROJECT` 处理其项目，或给出已连接测量系统的描述。</translation>
    </message>
    <message>
      <source>Remove the cause, check that nothing is in the way, then reset the stop.</source>
      <translation>请排除原因，确认无障碍，然后复位停止。</translation>
    </message>
    <message>
      <source>Rig {v1} is a recording: it has no devices that could be connected, moved or triggered.</source>
      <translation>测量系统 {v1} 是录制：没有可连接、移动或触发的设备。</translation>
    </message>
    <message>
      <source>Rig {v1} is in use: {v2} has connected {v3}.</source>
      <translation>测量系统 {v1} 正被使用：{v2} 已连接 {v3}。</translation>
    </message>
    <message>
      <source>Rig {v1}: the driver {v2} of {v3} failed: {v4}: {v5}.</source>
      <translation>测量系统 {v1}：{v3} 的驱动 {v2} 失败：{v4}：{v5}。</translation>
    </message>
    <message>
      <source>Rig {v1}: {v2} devices cannot be connected. {v3}</source>
      <translation>测量系统 {v1}：{v2} 台设备无法连接。{v3}</translation>
    </message>
    <message>
      <source>Rig {v1}: {v2}: {v3} (driver {v4}).</source>
      <translation>测量系统 {v1}：{v2}：{v3}（驱动 {v4}）。</translation>
    </message>
    <message>
      <source>Set port in [links] instead of usb_serial.</source>
      <translation>请在 [links] 中设置 port 而非 usb_serial。</translation>
    </message>
    <message>
      <source>Set the camera to global reset, or the projector to hold each pattern for the whole period.</source>
      <translation>请将相机设为全局复位，或让投影仪在整个周期保持每个图案。</translation>
    </message>
    <message>
      <source>Set the camera to rolling shutter, or use a projector that is dark after the exposure.</source>
      <translation>请将相机设为滚动快门，或使用曝光后变暗的投影仪。</translation>
    </message>
    <message>
      <source>The files in {v1} have changed since you were asked.</source>
      <translation>自询问之后，{v1} 中的文件已更改。</translation>
    </message>
    <message>
      <source>The plugin {v1} drives a {v2}, not a {v3}.</source>
      <translation>插件 {v1} 驱动的是{v2}，而非{v3}。</translation>
    </message>
    <message>
      <source>The projector sent {v1} trigger pulses for {v2} patterns: the images cannot be assigned to patterns.</source>
      <translation>投影仪为 {v2} 个图案送出了 {v1} 个触发脉冲：图像无法与图案对应。</translation>
    </message>
    <message>
      <source>The rig has no link {v1} (described: {v2}).</source>
      <translation>测量系统没有连接 {v1}（已描述：{v2}）。</translation>
    </message>
    <message>
      <source>The rig was stopped: {v1}</source>
      <translation>测量系统已停止：{v1}</translation>
    </message>
    <message>
      <source>There is no driver plugin {v1} (available: {v2}).</source>
      <translation>没有驱动插件 {v1}（可用：{v2}）。</translation>
    </message>
    <message>
      <source>[devices.{v1}] settings</source>
      <translation>[devices.{v1}] 的设置</translation>
    </message>
    <message>
      <source>a port, a host or a USB serial number</source>
      <translation>串口、主机或 USB 序列号</translation>
    </message>
    <message>
      <source>another program</source>
      <translation>另一程序</translation>
    </message>
    <message>
      <source>another program, process {v1}</source>
      <translation>另一程序，进程 {v1}</translation>
    </message>
    <message>
      <source>serial number {v1}</source>
      <translation>序列号 {v1}</translation>
    </message>
    <message>
      <source>the image has pixels of type {v1}, not {v2} for {v3} bit</source>
      <translation>图像的像素类型为 {v1}，而非 {v3} 位的 {v2}</translation>
    </message>
    <message>
      <source>the image is from camera {v1}, not {v2}</source>
      <translation>图像来自相机 {v1}，而非 {v2}</translation>
    </message>
    <message>
      <source>the image is {v1} px, not {v2} × {v3} px</source>
      <translation>图像为 {v1} px，而非 {v2} × {v3} px</translation>
    </message>
    <message>
      <source>the image was exposed for {v1} µs, not {v2} µs</source>
      <translation>图像曝光了 {v1} µs，而非 {v2} µs</translation>
    </message>
    <message>
      <source>the manifest</source>
      <translation>清单</translation>
    </message>
    <message>
      <source>the settings</source>
      <translation>设置</translation>
    </message>
    <message>
      <source>this program</source>
      <translation>本程序</translation>
    </message>
    <message>
      <source>{v1} (user {v2} at {v3}, since {v4})</source>
      <translation>{v1}（用户 {v2}，位于 {v3}，自 {v4}）</translation>
    </message>
    <message>
      <source>{v1} It was taken again {v2} times in vain.</source>
      <translation>{v1} 已重新拍摄 {v2} 次，均无效。</translation>
    </message>
    <message>
      <source>{v1} cannot be written: {v2}.</source>
      <translation>无法写入 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>{v1} did not end within {v2} s.</source>
      <translation>{v1} 在 {v2} s 内没有结束。</translation>
    </message>
    <message>
      <source>{v1} is not valid TOML: {v2}.</source>
      <translation>{v1} 不是有效的 TOML：{v2}。</translation>
    </message>
    <message>
      <source>{v1} of the packets were sent again: check cable, switch and packet delay</source>
      <translation>{v1} 的数据包被重发：请检查电缆、交换机和数据包间隔</translation>
    </message>
    <message>
      <source>{v1} serial ports have the USB serial number {v2} (adapters here: {v3}).</source>
      <translation>{v1} 个串口具有 USB 序列号 {v2}（此处的适配器：{v3}）。</translation>
    </message>
  </context>
  <context>
    <name>core.fringe</name>
    <message>
      <source> of camera {v1}</source>
      <translation>（相机 {v1}）</translation>
    </message>
    <message>
      <source>A + B = {v1} exceeds the saturation of {v2} grey levels.</source>
      <translation>A + B = {v1} 超过 {v2} 灰度级的饱和值。</translation>
    </message>
    <message>
      <source>A contrast of A = {v1}, B = {v2} grey levels cannot be.</source>
      <translation>对比度 A = {v1}、B = {v2} 灰度级是不可能的。</translation>
    </message>
    <message>
      <source>A single pitch of {v1} px repeats over the {v2} {v3} of the projector.</source>
      <translation>单一间距 {v1} px 在投影仪的 {v2} {v3} 上重复。</translation>
    </message>
    <message>
      <source>Add Gray planes, the most significant first, or a coarser pitch.</source>
      <translation>请添加格雷平面（最高位在前），或更粗的间距。</translation>
    </message>
    <message>
      <source>Add `complementary = true` to the group of the Gray code.</source>
      <translation>请在格雷码组中添加 `complementary = true`。</translation>
    </message>
    <message>
      <source>Add a phase-shift group of at least three images.</source>
      <translation>请添加至少三幅图像的相移组。</translation>
    </message>
    <message>
      <source>Add a second pitch or a Gray code that numbers the periods.</source>
      <translation>请添加第二个间距，或对周期编号的格雷码。</translation>
    </message>
    <message>
      <source>Add all images of one exposure together, 8 or 16 bits without sign.</source>
      <translation>请将一个曝光的所有图像一起添加，8 或 16 位无符号。</translation>
    </message>
    <message>
      <source>Add every exposure of every camera.</source>
      <translation>请添加每台相机的每个曝光。</translation>
    </message>
    <message>
      <source>Add the exposures from long to short, each once.</source>
      <translation>请从长到短添加曝光，每个一次。</translation>
    </message>
    <message>
      <source>Allow at least {v1} s.</source>
      <translation>请至少允许 {v1} s。</translation>
    </message>
    <message>
      <source>Allow longer exposures, open the apertures, or use more steps.</source>
      <translation>请允许更长曝光、开大光圈，或使用更多步数。</translation>
    </message>
    <message>
      <source>Allow more time, or a finer multiple.</source>
      <translation>请允许更多时间，或更细的倍数。</translation>
    </message>
    <message>
      <source>Brightness level {v1}{v2} has a single image.</source>
      <translation>亮度级 {v1}{v2} 只有一幅图像。</translation>
    </message>
    <message>
      <source>Camera {v1} changed size or bit depth between exposures.</source>
      <translation>相机 {v1} 在曝光之间改变了尺寸或位深。</translation>
    </message>
    <message>
      <source>Camera {v1} gave exposure {v2}, but {v3}.</source>
      <translation>相机 {v1} 给出了曝光 {v2}，但 {v3}。</translation>
    </message>
    <message>
      <source>Camera {v1} gave {v2} images of shape {v3}; one exposure has {v4} images.</source>
      <translation>相机 {v1} 给出 {v2} 幅形状为 {v3} 的图像；一个曝光有 {v4} 幅图像。</translation>
    </message>
    <message>
      <source>Camera {v1} has images of shape {v2}; the set needs {v3} exposures of {v4} images.</source>
      <translation>相机 {v1} 的图像形状为 {v2}；图案集需要 {v3} 个曝光，每个 {v4} 幅图像。</translation>
    </message>
    <message>
      <source>Camera {v1} has {v2} images.</source>
      <translation>相机 {v1} 有 {v2} 幅图像。</translation>
    </message>
    <message>
      <source>Change the sign of `shift_sign`, or reverse the order of the shifted images.</source>
      <translation>请改变 `shift_sign` 的符号，或颠倒相移图像的顺序。</translation>
    </message>
    <message>
      <source>Check shift_sign, the order of the images, the pitches and projector_px.</source>
      <translation>请检查 shift_sign、图像顺序、间距和 projector_px。</translation>
    </message>
    <message>
      <source>Check that no image was lost or taken without the pattern; record this group again.</source>
      <translation>请检查没有图像丢失或在无图案时拍摄；请重新录制该组。</translation>
    </message>
    <message>
      <source>Check that the camera took every exposure, without automatic gain.</source>
      <translation>请检查相机拍摄了每个曝光，且无自动增益。</translation>
    </message>
    <message>
      <source>Check that the projector stepped on; record again.</source>
      <translation>请检查投影仪已步进；请重新录制。</translation>
    </message>
    <message>
      <source>Check that the projector stepped on; record this group again.</source>
      <translation>请检查投影仪已步进；请重新录制该组。</translation>
    </message>
    <message>
      <source>Check the projector's lamp, the cameras' triggers and links, and ambient light.</source>
      <translation>请检查投影仪的灯、相机的触发和连接，以及环境光。</translation>
    </message>
    <message>
      <source>Choose pitches closer to each other, add a third pitch or a Gray code.</source>
      <translation>请选择彼此更接近的间距，添加第三个间距或格雷码。</translation>
    </message>
    <message>
      <source>Choose pitches whose longest beat is at least {v1} px.</source>
      <translation>请选择最长拍长至少为 {v1} px 的间距。</translation>
    </message>
    <message>
      <source>Estimate it from a grey ramp, or from six or more steps of one pitch.</source>
      <translation>请由灰度斜坡，或同一间距六步以上估计。</translation>
    </message>
    <message>
      <source>Estimate the projector's response with this pattern set.</source>
      <translation>请用此图案集估计投影仪的响应。</translation>
    </message>
    <message>
      <source>Expose longer, or turn the ambient light off.</source>
      <translation>请延长曝光，或关闭环境光。</translation>
    </message>
    <message>
      <source>Expose shorter.</source>
      <translation>请缩短曝光。</translation>
    </message>
    <message>
      <source>Exposures of camera {v1} are missing.</source>
      <translation>缺少相机 {v1} 的曝光。</translation>
    </message>
    <message>
      <source>Give 1 for the longest and fractions of it for the others.</source>
      <translation>最长者给 1，其余给其分数。</translation>
    </message>
    <message>
      <source>Give a contrast that the camera can see.</source>
      <translation>请给出相机能看到的对比度。</translation>
    </message>
    <message>
      <source>Give dark images too (lens covered), or switch the black level off.</source>
      <translation>请同时给出暗图像（盖上镜头），或关闭黑电平。</translation>
    </message>
    <message>
      <source>Give each of at least five levels once.</source>
      <translation>请至少五个电平各给出一次。</translation>
    </message>
    <message>
      <source>Give the first {v1} images of the Gray code only.</source>
      <translation>请只给出格雷码的前 {v1} 幅图像。</translation>
    </message>
    <message>
      <source>Give {v1} ≤ B ≤ A.</source>
      <translation>请给出 {v1} ≤ B ≤ A。</translation>
    </message>
    <message>
      <source>Image {v1} of camera {v2} at {v3} µs</source>
      <translation>相机 {v2} 在 {v3} µs 下的图像 {v1}</translation>
    </message>
    <message>
      <source>Image {v1} of camera {v2} at {v3} µs contradicts the other exposures {v4}.</source>
      <translation>相机 {v2} 在 {v3} µs 的图像 {v1} 与其他曝光矛盾{v4}。</translation>
    </message>
    <message>
      <source>Keep vibration away or wait longer after each move, and take the viewpoint again.</source>
      <translation>请避免振动，或在每次移动后等待更久，然后重新拍摄该视点。</translation>
    </message>
    <message>
      <source>No camera sees fringes at {v1} µs.</source>
      <translation>在 {v1} µs 时没有相机看到条纹。</translation>
    </message>
    <message>
      <source>No exposure up to {v1} µs makes a pixel decodable.</source>
      <translation>不超过 {v1} µs 的曝光都不能使像素可解码。</translation>
    </message>
    <message>
      <source>No multiple of {v1} µs fits into the budget.</source>
      <translation>没有 {v1} µs 的倍数适合该时间预算。</translation>
    </message>
    <message>
      <source>Only {v1} pixels show fringes that are neither saturated nor dark; {v2} are needed.</source>
      <translation>只有 {v1} 个像素显示既不饱和也不暗的条纹；需要 {v2} 个。</translation>
    </message>
    <message>
      <source>Pattern set {v1} has no sinusoids.</source>
      <translation>图案集 {v1} 没有正弦条纹。</translation>
    </message>
    <message>
      <source>Pattern set {v1} has {v2} Gray codes.</source>
      <translation>图案集 {v1} 有 {v2} 组格雷码。</translation>
    </message>
    <message>
      <source>Probe with a longer exposure, open the apertures, or check the projector.</source>
      <translation>请用更长曝光试测、开大光圈，或检查投影仪。</translation>
    </message>
    <message>
      <source>Probe with a phase-shift group.</source>
      <translation>请用相移组试测。</translation>
    </message>
    <message>
      <source>Probe with {v1} µs, or dim the projector.</source>
      <translation>请用 {v1} µs 试测，或调暗投影仪。</translation>
    </message>
    <message>
      <source>Put all Gray planes into one group.</source>
      <translation>请将所有格雷平面放在一组中。</translation>
    </message>
    <message>
      <source>Record a bright, matt surface that fills the image.</source>
      <translation>请录制充满图像的明亮哑光表面。</translation>
    </message>
    <message>
      <source>Record a viewpoint in one go.</source>
      <translation>请一次录完一个视点。</translation>
    </message>
    <message>
      <source>Record all cameras with one bit depth and give its saturation.</source>
      <translation>请以同一位深录制所有相机，并给出其饱和值。</translation>
    </message>
    <message>
      <source>Record all cameras with one bit depth.</source>
      <translation>请以同一位深录制所有相机。</translation>
    </message>
    <message>
      <source>Record at least three steps of every pitch.</source>
      <translation>请每个间距至少录制三步。</translation>
    </message>
    <message>
      <source>Record every pattern at every exposure.</source>
      <translation>请在每个曝光录制每个图案。</translation>
    </message>
    <message>
      <source>Record every pattern once; check that no file was copied over another.</source>
      <translation>请每个图案录制一次；检查没有文件被覆盖。</translation>
    </message>
    <message>
      <source>Record six or more steps; twelve are good.</source>
      <translation>请录制六步以上；十二步为佳。</translation>
    </message>
    <message>
      <source>Record this group again, or correct the order of its files.</source>
      <translation>请重新录制这一组，或更正其文件的顺序。</translation>
    </message>
    <message>
      <source>Remove `complementary = true` from the group of the Gray code, or add the shifted last plane.</source>
      <translation>请从格雷码组中删除 `complementary = true`，或添加移位的最后一个平面。</translation>
    </message>
    <message>
      <source>Remove exposures from the bracket.</source>
      <translation>请从包围曝光中去掉一些曝光。</translation>
    </message>
    <message>
      <source>Remove pitches: three are enough for any projector.</source>
      <translation>请去掉一些间距：三个对任何投影仪都足够。</translation>
    </message>
    <message>
      <source>Show the ramp from black to white.</source>
      <translation>请显示从黑到白的斜坡。</translation>
    </message>
    <message>
      <source>Sort the exposures of the stack.</source>
      <translation>请对图像组的曝光排序。</translation>
    </message>
    <message>
      <source>Take at least two images of every brightness.</source>
      <translation>请每个亮度至少拍摄两幅图像。</translation>
    </message>
    <message>
      <source>Take pairs of images of an evenly lit, unmoved surface at five or more exposures from dark to nearly saturated.</source>
      <translation>请对照明均匀且不移动的表面，在从暗到接近饱和的五个或更多曝光下成对拍摄图像。</translation>
    </message>
    <message>
      <source>The beat of the pitches {v1} px is {v2} px, shorter than the {v3} {v4} of the projector.</source>
      <translation>间距 {v1} px 的拍长为 {v2} px，短于投影仪的 {v3} {v4}。</translation>
    </message>
    <message>
      <source>The cameras have images of different bit depths ({v1}).</source>
      <translation>各相机图像的位深不同 ({v1})。</translation>
    </message>
    <message>
      <source>The exposures are not in order from long to short.</source>
      <translation>曝光不是从长到短的顺序。</translation>
    </message>
    <message>
      <source>The exposures {v1} are not relative to the longest.</source>
      <translation>曝光 {v1} 不是相对于最长者的。</translation>
    </message>
    <message>
      <source>The grey ramp covers the levels {v1}…{v2} of 0…255.</source>
      <translation>灰度斜坡覆盖 0…255 中的 {v1}…{v2}。</translation>
    </message>
    <message>
      <source>The grey ramp ends in equal levels: the camera or the projector saturates.</source>
      <translation>灰度斜坡以相同灰度结束：相机或投影仪饱和。</translation>
    </message>
    <message>
      <source>The grey ramp has {v1} different levels among {v2}.</source>
      <translation>灰度斜坡在 {v2} 个中有 {v1} 个不同灰度。</translation>
    </message>
    <message>
      <source>The grey ramp rises by {v1} grey levels only.</source>
      <translation>灰度斜坡只上升 {v1} 灰度级。</translation>
    </message>
    <message>
      <source>The harmonics of the projector are too strong for {v1} steps: equal phases come from different places.</source>
      <translation>对 {v1} 步而言投影仪的谐波太强：相同相位来自不同位置。</translation>
    </message>
    <message>
      <source>The images</source>
      <translation>图像</translation>
    </message>
    <message>
      <source>The images of brightness level {v1}{v2} differ by {v3} in brightness.</source>
      <translation>亮度级 {v1}{v2} 的图像亮度相差 {v3}。</translation>
    </message>
    <message>
      <source>The images of camera {v1}</source>
      <translation>相机 {v1} 的图像</translation>
    </message>
    <message>
      <source>The images of camera {v1} at {v2} µs are {v3} times as bright as those at {v4} µs, not {v5} times.</source>
      <translation>相机 {v1} 在 {v2} µs 的图像亮度为 {v4} µs 的 {v3} 倍，而非 {v5} 倍。</translation>
    </message>
    <message>
      <source>The phase correction is for {v1} pitches, pattern set {v2} has {v3}.</source>
      <translation>相位修正适用于 {v1} 个间距，图案集 {v2} 有 {v3} 个。</translation>
    </message>
    <message>
      <source>The phase decreases where the Gray code increases.</source>
      <translation>格雷码增大处相位减小。</translation>
    </message>
    <message>
      <source>The probe has no sinusoids.</source>
      <translation>试测没有正弦条纹。</translation>
    </message>
    <message>
      <source>The projector is {v1} px {v2}, the pattern set covers {v3} {v4}.</source>
      <translation>投影仪为 {v1} px {v2}，图案集覆盖 {v3} {v4}。</translation>
    </message>
    <message>
      <source>The range of {v1} is {v2} px for {v3} px of the projector: {v4} px of guard band, so that noise turns one edge into the other.</source>
      <translation>对投影仪的 {v3} px，{v1} 的范围为 {v2} px：保护带 {v4} px，噪声会使一边变为另一边。</translation>
    </message>
    <message>
      <source>The response of {v1} has no curve, so patterns cannot be corrected beforehand.</source>
      <translation>{v1} 的响应没有曲线，因此不能预先修正图案。</translation>
    </message>
    <message>
      <source>The steps of the group are out of order: {v1} and {v2} appear to be exchanged.</source>
      <translation>该组的步序不对：{v1} 与 {v2} 似乎互换。</translation>
    </message>
    <message>
      <source>The two exposures appear to be exchanged: check their order.</source>
      <translation>两个曝光似乎互换：请检查其顺序。</translation>
    </message>
    <message>
      <source>The variance of {v1} does not grow with its brightness.</source>
      <translation>{v1} 的方差不随亮度增大。</translation>
    </message>
    <message>
      <source>The variance of {v1} would vanish at grey level {v2}: it has a black level.</source>
      <translation>{v1} 的方差会在灰度 {v2} 处为零：它有黑电平。</translation>
    </message>
    <message>
      <source>Use 8- or 16-bit images without sign.</source>
      <translation>请使用 8 或 16 位无符号图像。</translation>
    </message>
    <message>
      <source>Use a pattern set made for this projector.</source>
      <translation>请使用为此投影仪制作的图案集。</translation>
    </message>
    <message>
      <source>Use a steady lamp (exposures of whole mains periods) and group images of one exposure.</source>
      <translation>请使用稳定的灯（曝光为市电周期的整数倍），并将同一曝光的图像归为一组。</translation>
    </message>
    <message>
      <source>Use more steps, or patterns corrected beforehand.</source>
      <translation>请使用更多步数，或预先修正的图案。</translation>
    </message>
    <message>
      <source>Use raw images: without gamma, denoising, automatic gain or lossy compression.</source>
      <translation>请使用原始图像：无伽马、降噪、自动增益或有损压缩。</translation>
    </message>
    <message>
      <source>all are there</source>
      <translation>已全部到齐</translation>
    </message>
    <message>
      <source>as a whole: it is {v1}</source>
      <translation>整体上：为 {v1}</translation>
    </message>
    <message>
      <source>black</source>
      <translation>黑色</translation>
    </message>
    <message>
      <source>border of a period</source>
      <translation>周期边界</translation>
    </message>
    <message>
      <source>brighter</source>
      <translation>更亮</translation>
    </message>
    <message>
      <source>columns</source>
      <translation>列</translation>
    </message>
    <message>
      <source>complementary Gray code</source>
      <translation>互补格雷码</translation>
    </message>
    <message>
      <source>darker</source>
      <translation>更暗</translation>
    </message>
    <message>
      <source>decoding {v1}</source>
      <translation>正在解码 {v1}</translation>
    </message>
    <message>
      <source>edge of the range</source>
      <translation>范围边缘</translation>
    </message>
    <message>
      <source>exposure {v1} of {v2} is due</source>
      <translation>应为第 {v1} 个曝光，共 {v2} 个</translation>
    </message>
    <message>
      <source>give a curve or waveforms</source>
      <translation>请给出 curve 或 waveforms</translation>
    </message>
    <message>
      <source>heterodyne of {v1} pitches</source>
      <translation>{v1} 节距外差</translation>
    </message>
    <message>
      <source>high</source>
      <translation>高</translation>
    </message>
    <message>
      <source>in {v1} of its pixels (it is {v2})</source>
      <translation>在其 {v1} 的像素中（为 {v2}）</translation>
    </message>
    <message>
      <source>quarter of a period</source>
      <translation>四分之一周期</translation>
    </message>
    <message>
      <source>the camera</source>
      <translation>该相机</translation>
    </message>
    <message>
      <source>the curve must ascend from (0, 0) to (255, 1)</source>
      <translation>曲线必须从 (0, 0) 上升到 (255, 1)</translation>
    </message>
    <message>
      <source>white</source>
      <translation>白色</translation>
    </message>
    <message>
      <source>wide</source>
      <translation>宽</translation>
    </message>
    <message>
      <source>{v1} Gray planes number {v2} periods of {v3} px: {v4} of {v5} {v6}.</source>
      <translation>{v1} 个格雷平面为 {v2} 个 {v3} px 的周期编号：{v6}{v5} 中的 {v4}。</translation>
    </message>
    <message>
      <source>{v1} are saturated, black, or too small everywhere.</source>
      <translation>{v1} 到处饱和、全黑或过小。</translation>
    </message>
    <message>
      <source>{v1} bits</source>
      <translation>{v1} 位</translation>
    </message>
    <message>
      <source>{v1} changes in the middle of the periods that the other Gray code planes number: the code is complementary, and its description does not state it.</source>
      <translation>{v1} 在其他格雷码平面所编号周期的中间变化：该码为互补格雷码，而其描述未说明这一点。</translation>
    </message>
    <message>
      <source>{v1} changes where the other Gray code planes do: the code is plain, and its description states a complementary one.</source>
      <translation>{v1} 与其他格雷码平面在相同位置变化：该码为普通格雷码，而其描述为互补格雷码。</translation>
    </message>
    <message>
      <source>{v1} does not fit the other steps of its group.</source>
      <translation>{v1} 与其组的其他步不符。</translation>
    </message>
    <message>
      <source>{v1} exposures are more than {v2}.</source>
      <translation>{v1} 个曝光超过 {v2} 个。</translation>
    </message>
    <message>
      <source>{v1} give {v2} usable brightness levels from {v3} to {v4} grey levels: gain and read noise cannot be separated.</source>
      <translation>{v1} 给出从 {v3} 到 {v4} 灰度级的 {v2} 个可用亮度级：无法区分增益与读出噪声。</translation>
    </message>
    <message>
      <source>{v1} has grey levels up to {v2}, but the stack saturates at {v3}.</source>
      <translation>{v1} 的灰度达 {v2}，但图像组在 {v3} 饱和。</translation>
    </message>
    <message>
      <source>{v1} images of camera {v2} contradict the other exposures, in up to {v3} of their pixels, although they are as bright as predicted: the fringes moved during the images, by vibration, or because a part or axis had not settled.</source>
      <translation>相机 {v2} 的 {v1} 幅图像与其他曝光矛盾，最多达 {v3} 的像素，尽管亮度与预测一致：拍摄期间条纹发生了移动，原因是振动，或零件或轴尚未静止。</translation>
    </message>
    <message>
      <source>{v1} is the inverse of {v2}, and so are all that follow: inverse Gray code planes number no periods.</source>
      <translation>{v1} 是 {v2} 的反相图像，其后各幅亦然：反相的格雷码平面不对周期编号。</translation>
    </message>
    <message>
      <source>{v1} is the same as {v2}.</source>
      <translation>{v1} 与 {v2} 相同。</translation>
    </message>
    <message>
      <source>{v1} is {v2} everywhere than the others of its group: it shows no fringes.</source>
      <translation>{v1} 到处都比其组的其他图像{v2}：它没有条纹。</translation>
    </message>
    <message>
      <source>{v1} is {v2} everywhere where a coarser Gray code plane has stripes.</source>
      <translation>在更粗的格雷码平面有条纹之处，{v1} 到处为{v2}。</translation>
    </message>
    <message>
      <source>{v1} of the lit pixels are saturated even at {v2} µs.</source>
      <translation>照亮像素的 {v1} 在 {v2} µs 时仍饱和。</translation>
    </message>
    <message>
      <source>{v1} of the phases of camera {v2} lie beyond the projector.</source>
      <translation>相机 {v2} 的相位有 {v1} 超出投影仪。</translation>
    </message>
    <message>
      <source>{v1} pitches are more than {v2}.</source>
      <translation>{v1} 个间距超过 {v2} 个。</translation>
    </message>
    <message>
      <source>{v1} s do not suffice for one exposure of {v2} images.</source>
      <translation>{v1} s 不足以进行 {v2} 幅图像的一个曝光。</translation>
    </message>
    <message>
      <source>{v1} shifted images do not determine mean, modulation and phase.</source>
      <translation>{v1} 幅相移图像不能确定均值、调制度和相位。</translation>
    </message>
    <message>
      <source>{v1} shifted images do not separate harmonics from noise.</source>
      <translation>{v1} 幅相移图像不能区分谐波与噪声。</translation>
    </message>
    <message>
      <source>{v1} shows the same Gray code plane as {v2}.</source>
      <translation>{v1} 显示与 {v2} 相同的格雷码平面。</translation>
    </message>
    <message>
      <source>{v1} shows the same pattern as {v2}.</source>
      <translation>{v1} 显示与 {v2} 相同的图案。</translation>
    </message>
    <message>
      <source>{v1} times as bright as they predict, all images of its exposure {v2} times</source>
      <translation>其预计亮度的 {v1} 倍，该曝光的所有图像为 {v2} 倍</translation>
    </message>
    <message>
      <source>{v1} → {v2} periods</source>
      <translation>{v1} → {v2} 个周期</translation>
    </message>
    <message>
      <source>{v1}: {v2} bit</source>
      <translation>{v1}：{v2} 位</translation>
    </message>
  </context>
  <context>
    <name>core.geometry</name>
    <message>
      <source>A {v1} cannot be fitted.</source>
      <translation>无法拟合{v1}。</translation>
    </message>
    <message>
      <source>A {v1} needs at least {v2} points; there are {v3}.</source>
      <translation>{v1}至少需要 {v2} 个点；现有 {v3} 个。</translation>
    </message>
    <message>
      <source>Correct its nominal, or its limits.</source>
      <translation>请更正其名义值或其范围。</translation>
    </message>
    <message>
      <source>Correct the numbers after joint 6.</source>
      <translation>请更正关节 6 之后的数字。</translation>
    </message>
    <message>
      <source>Correct the numbers of this joint.</source>
      <translation>请更正此关节的数字。</translation>
    </message>
    <message>
      <source>Give its direction.</source>
      <translation>请给出其方向。</translation>
    </message>
    <message>
      <source>Give more points.</source>
      <translation>请给出更多点。</translation>
    </message>
    <message>
      <source>Give one weight per point.</source>
      <translation>请为每个点给出一个权重。</translation>
    </message>
    <message>
      <source>Give points spread over more of the cone, or fit a cylinder.</source>
      <translation>请给出分布在圆锥更大部分上的点，或拟合圆柱。</translation>
    </message>
    <message>
      <source>Give points spread over more of the {v1}.</source>
      <translation>请给出分布在{v1}更大部分上的点。</translation>
    </message>
    <message>
      <source>Give the normal of its plane or face.</source>
      <translation>请给出其平面或面的法线。</translation>
    </message>
    <message>
      <source>Inverse kinematics needs base_from_flange, not {v1}_from_{v2}.</source>
      <translation>逆运动学需要从法兰到基座的变换，而非从{v2}到{v1}的变换。</translation>
    </message>
    <message>
      <source>It is probably out of reach: move the goal closer to the robot, {v1}.</source>
      <translation>可能够不到：请将目标移近机器人，{v1}。</translation>
    </message>
    <message>
      <source>Its 3×3 part must be a rotation.</source>
      <translation>其 3×3 部分必须是旋转。</translation>
    </message>
    <message>
      <source>Joint {v1} of {v2} has {v3}.</source>
      <translation>{v2} 的关节 {v1} 有 {v3}。</translation>
    </message>
    <message>
      <source>Move the goal away from axis 1, {v1}.</source>
      <translation>请将目标移离轴 1，{v1}。</translation>
    </message>
    <message>
      <source>Move the goal {v1} the robot, {v2}.</source>
      <translation>请将目标{v1}机器人，{v2}。</translation>
    </message>
    <message>
      <source>Multiply by the transforms to base and flange first.</source>
      <translation>请先与到基座和法兰的变换相乘。</translation>
    </message>
    <message>
      <source>Narrow the limits to the turns in use: at most {v1} equivalent positions.</source>
      <translation>请将限位缩小到所用圈数：最多 {v1} 个等效位置。</translation>
    </message>
    <message>
      <source>Points for a fit must be rows of three finite numbers.</source>
      <translation>拟合用的点必须是每行三个有限数。</translation>
    </message>
    <message>
      <source>Remove lines that are not points.</source>
      <translation>请去掉不是点的行。</translation>
    </message>
    <message>
      <source>Rotate the head about its viewing direction, change the pose, {v1}.</source>
      <translation>请绕测头的视线方向转动测头、改变位姿，{v1}。</translation>
    </message>
    <message>
      <source>Select the points of one surface only, or give a start.</source>
      <translation>请只选择一个表面的点，或给出初值。</translation>
    </message>
    <message>
      <source>Shift the pose by 10 mm or tilt it by a degree.</source>
      <translation>请将位姿平移 10 mm 或倾斜 1°。</translation>
    </message>
    <message>
      <source>The contour {v1} has no direction.</source>
      <translation>轮廓 {v1} 没有方向。</translation>
    </message>
    <message>
      <source>The contour {v1} has no normal.</source>
      <translation>轮廓 {v1} 没有法线。</translation>
    </message>
    <message>
      <source>The flange of {v1} has no rigid transform.</source>
      <translation>{v1} 的法兰没有刚性变换。</translation>
    </message>
    <message>
      <source>The inner frames of a product must be the same.</source>
      <translation>乘积的内侧坐标系必须相同。</translation>
    </message>
    <message>
      <source>The joint limits of {v1} allow {v2} equivalent positions, whole turns apart, for one pose.</source>
      <translation>{v1} 的关节限位对一个位姿允许 {v2} 个相差整圈的等效位置。</translation>
    </message>
    <message>
      <source>The minimum-zone fit did not converge.</source>
      <translation>最小区域拟合未收敛。</translation>
    </message>
    <message>
      <source>The points are not on a {v1}.</source>
      <translation>这些点不在{v1}上。</translation>
    </message>
    <message>
      <source>The points do not determine a cone.</source>
      <translation>这些点不能确定圆锥。</translation>
    </message>
    <message>
      <source>The points do not determine a {v1}.</source>
      <translation>这些点不能确定{v1}。</translation>
    </message>
    <message>
      <source>The points do not determine a {v1}: the fit does not converge.</source>
      <translation>这些点不能确定{v1}：拟合不收敛。</translation>
    </message>
    <message>
      <source>The weights of a fit must be positive, one per point.</source>
      <translation>拟合的权重必须为正，每点一个。</translation>
    </message>
    <message>
      <source>Use one of: {v1}.</source>
      <translation>请使用以下之一：{v1}。</translation>
    </message>
    <message>
      <source>Use the least-squares criterion, or remove outliers first.</source>
      <translation>请用最小二乘准则，或先去除离群点。</translation>
    </message>
    <message>
      <source>a singularity (condition {v1})</source>
      <translation>奇异（条件数 {v1}）</translation>
    </message>
    <message>
      <source>an axis that is not a unit vector</source>
      <translation>某轴不是单位向量</translation>
    </message>
    <message>
      <source>away from</source>
      <translation>移离</translation>
    </message>
    <message>
      <source>closer to</source>
      <translation>移近</translation>
    </message>
    <message>
      <source>far</source>
      <translation>远</translation>
    </message>
    <message>
      <source>folded</source>
      <translation>折叠</translation>
    </message>
    <message>
      <source>joint 5 at {v1}°, a singularity of the wrist (axes 4 and 6 in line)</source>
      <translation>关节 5 在 {v1}°，为腕部奇异（轴 4 与轴 6 共线）</translation>
    </message>
    <message>
      <source>near</source>
      <translation>近</translation>
    </message>
    <message>
      <source>no lower limit below its upper limit</source>
      <translation>下限不低于上限</translation>
    </message>
    <message>
      <source>no positive speed</source>
      <translation>速度不为正</translation>
    </message>
    <message>
      <source>no rigid transform from the link before</source>
      <translation>相对前一连杆没有刚体变换</translation>
    </message>
    <message>
      <source>or let the linear guide or the rotary table take over</source>
      <translation>或由直线导轨或转台承担</translation>
    </message>
    <message>
      <source>straight</source>
      <translation>伸直</translation>
    </message>
    <message>
      <source>the elbow {v1}° from the {v2} arm, a singularity</source>
      <translation>肘部距{v2}的手臂 {v1}°，为奇异</translation>
    </message>
    <message>
      <source>the wrist {v1} mm from axis 1, where joint 1 is not determined</source>
      <translation>腕部距轴 1 {v1} mm，此处关节 1 不确定</translation>
    </message>
    <message>
      <source>{v1}: every configuration is near a singularity, such as {v2}.</source>
      <translation>{v1}：每种构型都接近奇异，例如{v2}。</translation>
    </message>
    <message>
      <source>{v1}: no joint angles were found for this pose; the nearest miss it by {v2} mm and {v3}°.</source>
      <translation>{v1}：未找到此位姿的关节角；最接近的偏差为 {v2} mm 和 {v3}°。</translation>
    </message>
    <message>
      <source>{v1}: the pose has {v2}.</source>
      <translation>{v1}：该位姿有{v2}。</translation>
    </message>
    <message>
      <source>{v1}: the pose needs joint {v2} at {v3}°, outside {v4}…{v5}°, {v6}° too far in the best configuration.</source>
      <translation>{v1}：该位姿需要关节 {v2} 为 {v3}°，超出 {v4}…{v5}°，最佳构型下超出 {v6}°。</translation>
    </message>
    <message>
      <source>{v1}: the wrist would be {v2} mm from axis 1; its lateral offset keeps it at least {v3} mm away: {v4} mm too near.</source>
      <translation>{v1}：腕部距轴 1 将为 {v2} mm；其侧向偏置使其至少保持 {v3} mm：近了 {v4} mm。</translation>
    </message>
    <message>
      <source>{v1}: the wrist would be {v2} mm from the shoulder; the arm reaches {v3}…{v4} mm: {v5} mm too {v6}.</source>
      <translation>{v1}：腕部距肩部将为 {v2} mm；手臂可达 {v3}…{v4} mm：过{v6} {v5} mm。</translation>
    </message>
    <message>
      <source>{v1}_from_{v2} cannot be multiplied by {v3}_from_{v4}.</source>
      <translation>从{v2}到{v1}的变换不能与从{v4}到{v3}的变换相乘。</translation>
    </message>
    <message>
      <source>{v1}_from_{v2} is not a rigid transform.</source>
      <translation>从{v2}到{v1}的变换不是刚体变换。</translation>
    </message>
  </context>
  <context>
    <name>core.inspection</name>
    <message>
      <source>, certificate {v1}</source>
      <translation>，证书 {v1}</translation>
    </message>
    <message>
      <source>, small segment: Monte Carlo, {v1} draws</source>
      <translation>，弧段小：蒙特卡洛，{v1} 次抽样</translation>
    </message>
    <message>
      <source>, {v1} sections</source>
      <translation>，{v1} 个截面</translation>
    </message>
    <message>
      <source>1 dimension, chi-square test at a level of {v1}</source>
      <translation>1 个尺寸，卡方检验，显著性水平 {v1}</translation>
    </message>
    <message>
      <source>3-2-1 (plane {v1}, line {v2}, point {v3})</source>
      <translation>3-2-1（平面 {v1}、直线 {v2}、点 {v3}）</translation>
    </message>
    <message>
      <source>A face beside this edge is only {v1} mm wide.</source>
      <translation>该棱边旁的一个面仅宽 {v1} mm。</translation>
    </message>
    <message>
      <source>A hole pattern is found on the CAD model only, and there is none.</source>
      <translation>孔组只能在 CAD 模型上查找，而此处没有模型。</translation>
    </message>
    <message>
      <source>A line profile needs a section plane: state `section` in the text of the program.</source>
      <translation>线轮廓度需要截面：请在程序文本中给出 `section`。</translation>
    </message>
    <message>
      <source>A local best fit cannot use {v1}: its points are not cut around a nominal.</source>
      <translation>局部最佳拟合不能使用 {v1}：其点不是按名义裁取的。</translation>
    </message>
    <message>
      <source>A material condition needs the limits of the diameter, the smaller one first.</source>
      <translation>实体要求需要直径的极限值，先小后大。</translation>
    </message>
    <message>
      <source>A pattern is made of at least two holes.</source>
      <translation>孔组至少由两个孔构成。</translation>
    </message>
    <message>
      <source>A spread needs at least two measurements.</source>
      <translation>离散至少需要两次测量。</translation>
    </message>
    <message>
      <source>A {v1} has no datums: it compares the feature with itself.</source>
      <translation>{v1} 没有基准：它只与要素自身比较。</translation>
    </message>
    <message>
      <source>A {v1} has one datum.</source>
      <translation>{v1} 只有一个基准。</translation>
    </message>
    <message>
      <source>A {v1} needs a datum.</source>
      <translation>{v1} 需要基准。</translation>
    </message>
    <message>
      <source>Add one to the program (nominal = "…"), or set alignment = "none".</source>
      <translation>请向程序添加一个 (nominal = "…")，或设置 alignment = "none"。</translation>
    </message>
    <message>
      <source>Change its values.</source>
      <translation>请修改其数值。</translation>
    </message>
    <message>
      <source>Change the entry it names first.</source>
      <translation>请先更改它指出的条目。</translation>
    </message>
    <message>
      <source>Check that this is the nominal of the part, or crop the surroundings from the cloud.</source>
      <translation>请检查这是否为工件的名义模型，或裁去点云的周围部分。</translation>
    </message>
    <message>
      <source>Choose another alignment first.</source>
      <translation>请先选择另一对齐。</translation>
    </message>
    <message>
      <source>Choose another alignment.</source>
      <translation>请选择另一对齐。</translation>
    </message>
    <message>
      <source>Choose another characteristic, feature or datum.</source>
      <translation>请选择其他特性、要素或基准。</translation>
    </message>
    <message>
      <source>Choose another letter, or remove what refers to it.</source>
      <translation>请选择其他字母，或先删除引用它的条目。</translation>
    </message>
    <message>
      <source>Choose another shape, or another seed.</source>
      <translation>请选择另一形状，或另一种子。</translation>
    </message>
    <message>
      <source>Choose measured features.</source>
      <translation>请选择测量的特征。</translation>
    </message>
    <message>
      <source>Choose one of its entries.</source>
      <translation>请选择其条目之一。</translation>
    </message>
    <message>
      <source>Choose other features, or another alignment.</source>
      <translation>请选择其他特征，或另一对齐。</translation>
    </message>
    <message>
      <source>Choose the nominal of this part, or crop the surroundings from the cloud.</source>
      <translation>请选择此工件的名义模型，或裁去点云的周围部分。</translation>
    </message>
    <message>
      <source>Choose the toleranced feature.</source>
      <translation>请选择被测要素。</translation>
    </message>
    <message>
      <source>Click an edge between two wider faces.</source>
      <translation>请单击两个较宽的面之间的棱边。</translation>
    </message>
    <message>
      <source>Click another place.</source>
      <translation>请单击其他位置。</translation>
    </message>
    <message>
      <source>Click both round ends first, then both straight sides; a slot is longer than wide.</source>
      <translation>请先单击两个圆端，再单击两条直边；槽的长度大于宽度。</translation>
    </message>
    <message>
      <source>Click closer to it; where the edge is rounded, construct the intersection of its two faces.</source>
      <translation>请单击得更靠近棱边；若棱边已倒圆，请构造其两个面的交线。</translation>
    </message>
    <message>
      <source>Click measured points.</source>
      <translation>请单击测量点。</translation>
    </message>
    <message>
      <source>Click one place on each of the two faces of the edge.</source>
      <translation>请在棱边的两个面上各单击一处。</translation>
    </message>
    <message>
      <source>Click one place on each of the two faces, a few millimetres beside the edge.</source>
      <translation>请在两个面上各单击一处，距棱边几毫米。</translation>
    </message>
    <message>
      <source>Click the other end of the line.</source>
      <translation>请单击直线的另一端。</translation>
    </message>
    <message>
      <source>Click the same wall each time, at places spread around it.</source>
      <translation>请每次都单击同一壁面，且各处沿周向分布。</translation>
    </message>
    <message>
      <source>Click the wall of the hole, or its edge on the face beside it.</source>
      <translation>请单击孔壁，或其旁边面上的孔口棱边。</translation>
    </message>
    <message>
      <source>Click the wall, at places spread around it.</source>
      <translation>请单击壁面，且各处沿周向分布。</translation>
    </message>
    <message>
      <source>Click two faces that border on each other.</source>
      <translation>请单击两个相邻的面。</translation>
    </message>
    <message>
      <source>Click two places of one face, along the straight direction of a curved one.</source>
      <translation>请单击同一面上的两处；曲面上应沿其直母线方向。</translation>
    </message>
    <message>
      <source>Click where the part follows the model, or display the model itself.</source>
      <translation>请单击工件与模型相符之处，或显示模型本身。</translation>
    </message>
    <message>
      <source>Compute the surface again.</source>
      <translation>请重新计算表面。</translation>
    </message>
    <message>
      <source>Create a circle if it is round; measure the sides of a square slot as planes.</source>
      <translation>若为圆形请创建圆；方槽的侧面请按平面测量。</translation>
    </message>
    <message>
      <source>Create a circle there, or a line on one of its faces.</source>
      <translation>请在该处创建圆，或在其一个面上创建直线。</translation>
    </message>
    <message>
      <source>Create a circle.</source>
      <translation>请创建圆。</translation>
    </message>
    <message>
      <source>Create a slot if it has two round ends, or grow another shape by Feature.</source>
      <translation>若有两个圆端请创建槽，或通过“特征”生长其他形状。</translation>
    </message>
    <message>
      <source>Create the holes as circles, select them, then choose Hole pattern.</source>
      <translation>请先将各孔创建为圆，选中它们，再选择“孔组”。</translation>
    </message>
    <message>
      <source>Create them one by one, as circles.</source>
      <translation>请逐个创建为圆。</translation>
    </message>
    <message>
      <source>Create this one as a circle.</source>
      <translation>请将此孔创建为圆。</translation>
    </message>
    <message>
      <source>Datum {v1} constrains nothing beyond {v2}</source>
      <translation>基准 {v1} 除 {v2} 外不约束任何自由度</translation>
    </message>
    <message>
      <source>Enter another name.</source>
      <translation>请输入另一名称。</translation>
    </message>
    <message>
      <source>Enter at least one character.</source>
      <translation>请至少输入一个字符。</translation>
    </message>
    <message>
      <source>Export the cloud again without invalid points.</source>
      <translation>请重新导出不含无效点的点云。</translation>
    </message>
    <message>
      <source>Export the nominal again as STL, PLY or OBJ with triangles.</source>
      <translation>请将名义模型重新导出为含三角形的 STL、PLY 或 OBJ。</translation>
    </message>
    <message>
      <source>Feature {v1} has no direction.</source>
      <translation>特征 {v1} 没有方向。</translation>
    </message>
    <message>
      <source>ISO 14253-1 with a guard band of the expanded uncertainty (k = 2): PASS inside the tolerance reduced by it, FAIL outside the tolerance widened by it, otherwise NOT PROVEN.</source>
      <translation>ISO 14253-1，以扩展不确定度（k = 2）为保护带：在按其缩小的公差内为合格，在按其扩大的公差外为不合格，否则为未证实。</translation>
    </message>
    <message>
      <source>ISO 14253-1:2017: PASS when the true value lies within the tolerance with a probability of at least 95 %, FAIL when it lies beyond one limit with at least 95 %, otherwise NOT PROVEN. Uncertainties are expanded, k = 2.</source>
      <translation>ISO 14253-1:2017：真值以至少 95 % 的概率位于公差内时为合格，以至少 95 % 的概率超出某一极限时为不合格，否则为未证实。不确定度为扩展不确定度，k = 2。</translation>
    </message>
    <message>
      <source>If it is, use `--nominal-unit {v1}`, in a program `nominal_unit = "{v2}"`; otherwise export the nominal in millimetres.</source>
      <translation>若是，请用 `--nominal-unit {v1}`，在程序中用 `nominal_unit = "{v2}"`；否则请以毫米导出名义模型。</translation>
    </message>
    <message>
      <source>If they are, use `--unit {v1}`; otherwise scale the cloud to millimetres.</source>
      <translation>若是，请用 `--unit {v1}`；否则请将点云缩放到毫米。</translation>
    </message>
    <message>
      <source>Inspect all projects with the same program: measureapp process PROJECT, or the Inspect page.</source>
      <translation>请用同一程序检测所有项目：measureapp process PROJECT，或“检测”页。</translation>
    </message>
    <message>
      <source>Inspect it with a program that has dimensions.</source>
      <translation>请用有尺寸的程序检测。</translation>
    </message>
    <message>
      <source>Limit it by x_mm, y_mm or z_mm of its cut, or define a nominal.</source>
      <translation>请用其裁剪的 x_mm、y_mm 或 z_mm 限制，或定义名义模型。</translation>
    </message>
    <message>
      <source>Limit it by x_mm, y_mm or z_mm of its cut.</source>
      <translation>请用其裁剪的 x_mm、y_mm 或 z_mm 限制。</translation>
    </message>
    <message>
      <source>Measure it as a plane, cylinder or cone.</source>
      <translation>请将其作为平面、圆柱或圆锥测量。</translation>
    </message>
    <message>
      <source>Monte Carlo</source>
      <translation>蒙特卡洛</translation>
    </message>
    <message>
      <source>Monte Carlo, {v1} draws</source>
      <translation>蒙特卡洛，{v1} 次抽样</translation>
    </message>
    <message>
      <source>Monte Carlo, {v1} trials</source>
      <translation>蒙特卡洛，{v1} 次试验</translation>
    </message>
    <message>
      <source>Most of U is what the error model does not explain: a contradicted model proves nothing; see the checks of the error model</source>
      <translation>U 的大部分是误差模型不能解释的：与实测矛盾的模型什么也证明不了；请参见误差模型的检验</translation>
    </message>
    <message>
      <source>Motions not fixed by the features: from {v1}</source>
      <translation>特征未约束的运动：取自 {v1}</translation>
    </message>
    <message>
      <source>Move it further inside the surface.</source>
      <translation>请将其移到表面更内侧。</translation>
    </message>
    <message>
      <source>Name each measurement once; a spread needs independent scans.</source>
      <translation>每次测量只列一次；离散需要独立的扫描。</translation>
    </message>
    <message>
      <source>Name two or more projects of the same part.</source>
      <translation>请指定同一工件的两个以上项目。</translation>
    </message>
    <message>
      <source>No dimension has both a spread and a stated uncertainty to compare it with.</source>
      <translation>没有尺寸同时具有离散和可与之比较的给定不确定度。</translation>
    </message>
    <message>
      <source>No shape grows from this place.</source>
      <translation>从此处不能生长任何形状。</translation>
    </message>
    <message>
      <source>No spread contradicts the stated uncertainty ({v1}). Systematic errors cause no spread.</source>
      <translation>没有离散与给定的不确定度矛盾（{v1}）。系统误差不产生离散。</translation>
    </message>
    <message>
      <source>Nothing was measured at a clicked place.</source>
      <translation>某个单击处没有测量数据。</translation>
    </message>
    <message>
      <source>One of {v1} positions about the axis fits: {v2} mm rms, second best {v3} mm</source>
      <translation>绕轴的 {v1} 个位置中有一个相符：{v2} mm rms，次优 {v3} mm</translation>
    </message>
    <message>
      <source>Only {v1} of the points lie within {v2} mm of the nominal, in any orientation.</source>
      <translation>在任何方位，只有 {v1} 的点位于名义模型 {v2} mm 以内。</translation>
    </message>
    <message>
      <source>Only {v1} points lie in the features and regions of the local best fit, {v2} are needed.</source>
      <translation>局部最佳拟合的特征和区域中只有 {v1} 个点，需要 {v2} 个。</translation>
    </message>
    <message>
      <source>Only {v1} points were measured within {v2} mm of this place, {v3} are needed.</source>
      <translation>此处 {v2} mm 内只测量了 {v1} 个点，需要 {v3} 个。</translation>
    </message>
    <message>
      <source>RPS ({v1} points: {v2})</source>
      <translation>RPS（{v1} 个点：{v2}）</translation>
    </message>
    <message>
      <source>Read as {v1}, {v2} {v3}; read as millimetres, {v4}</source>
      <translation>按{v1}读取时，{v3}为 {v2}；按毫米读取时为 {v4}</translation>
    </message>
    <message>
      <source>Remove these as well, or give them other features first.</source>
      <translation>请同时移除这些，或先给它们其他特征。</translation>
    </message>
    <message>
      <source>Rename it, so that references follow.</source>
      <translation>请重命名，使引用随之更改。</translation>
    </message>
    <message>
      <source>Scale of lengths {v1}: {v2}.</source>
      <translation>长度比例 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>Scan its other side as well.</source>
      <translation>请也扫描其另一侧。</translation>
    </message>
    <message>
      <source>Scan the blade more densely.</source>
      <translation>请更密地扫描叶片。</translation>
    </message>
    <message>
      <source>Scan the faces beside it, or click faces that meet.</source>
      <translation>请扫描其旁边的面，或单击相交的面。</translation>
    </message>
    <message>
      <source>Scan the part first, or check the file.</source>
      <translation>请先扫描工件，或检查文件。</translation>
    </message>
    <message>
      <source>Scan these features, or choose others.</source>
      <translation>请扫描这些特征，或选择其他特征。</translation>
    </message>
    <message>
      <source>Scan this area from another side.</source>
      <translation>请从另一侧扫描此区域。</translation>
    </message>
    <message>
      <source>Scan this area more densely.</source>
      <translation>请更密地扫描此区域。</translation>
    </message>
    <message>
      <source>Scan this feature, or align by features that were measured.</source>
      <translation>请扫描此特征，或按已测量的特征对齐。</translation>
    </message>
    <message>
      <source>Select circles, cylinders or slots that are no copies of a pattern in the list of features.</source>
      <translation>请在特征列表中选择不属于阵列副本的圆、圆柱或槽。</translation>
    </message>
    <message>
      <source>Select equal holes.</source>
      <translation>请选择相同的孔。</translation>
    </message>
    <message>
      <source>Simple acceptance: PASS within the tolerance, FAIL outside; the uncertainty (k = 2) is stated but not subtracted.</source>
      <translation>简单接受：在公差内为合格，在公差外为不合格；不确定度（k = 2）给出但不扣除。</translation>
    </message>
    <message>
      <source>Some measured points are not finite numbers.</source>
      <translation>部分测量点不是有限数值。</translation>
    </message>
    <message>
      <source>Straightness of a plane needs the direction of its lines: state `along` in the text of the program.</source>
      <translation>平面的直线度需要直线的方向：请在程序文本中给出 `along`。</translation>
    </message>
    <message>
      <source>Temperature of the lengths: {v1}.</source>
      <translation>长度的温度：{v1}。</translation>
    </message>
    <message>
      <source>The CAD model has no other hole of this size and direction.</source>
      <translation>CAD 模型中没有其他尺寸和方向相同的孔。</translation>
    </message>
    <message>
      <source>The alignment of the program does not show whether the part was clamped anew between the measurements.</source>
      <translation>程序的对齐无法表明各次测量之间工件是否重新装夹。</translation>
    </message>
    <message>
      <source>The alignment of the program uses {v1}.</source>
      <translation>程序的对齐使用 {v1}。</translation>
    </message>
    <message>
      <source>The alignment {v1} failed: {v2}.</source>
      <translation>对齐 {v1} 失败：{v2}。</translation>
    </message>
    <message>
      <source>The certified length {v1} is off by {v2} mm, more than its uncertainty of {v3} mm (k = 2) explains: check its features and its certificate, or calibrate again</source>
      <translation>证书长度 {v1} 偏差 {v2} mm，超出其不确定度 {v3} mm (k = 2) 所能解释的范围：请检查其要素和证书，或重新标定</translation>
    </message>
    <message>
      <source>The change is not possible: {v1}.</source>
      <translation>无法更改：{v1}。</translation>
    </message>
    <message>
      <source>The clicked place is {v1} mm off the CAD model.</source>
      <translation>单击处偏离 CAD 模型 {v1} mm。</translation>
    </message>
    <message>
      <source>The clicked wall is as long as wide: it is round.</source>
      <translation>所单击壁面的长度与宽度相等：它是圆形。</translation>
    </message>
    <message>
      <source>The clicks are not on one wall.</source>
      <translation>各单击处不在同一壁面上。</translation>
    </message>
    <message>
      <source>The clicks are not on the ends and sides of one slot.</source>
      <translation>各单击处不在同一个槽的两端和两侧。</translation>
    </message>
    <message>
      <source>The clicks are on one flat face.</source>
      <translation>各单击处在同一平面上。</translation>
    </message>
    <message>
      <source>The datums {v1} do not fix the {v2} of {v3}: free are {v4}</source>
      <translation>基准 {v1} 不能固定 {v3} 的{v2}：自由的有 {v4}</translation>
    </message>
    <message>
      <source>The edge at the clicked place is curved.</source>
      <translation>单击处的棱边是弯曲的。</translation>
    </message>
    <message>
      <source>The feature cannot be used: {v1}.</source>
      <translation>该特征无法使用：{v1}。</translation>
    </message>
    <message>
      <source>The inspection program has no {v1} {v2}.</source>
      <translation>检测程序没有{v1} {v2}。</translation>
    </message>
    <message>
      <source>The name of {v1} is not one of its values.</source>
      <translation>{v1} 的名称不是其值之一。</translation>
    </message>
    <message>
      <source>The nominal extends from {v1} to {v2} mm: place the section inside.</source>
      <translation>名义模型从 {v1} 延伸到 {v2} mm：请将截面放在其内。</translation>
    </message>
    <message>
      <source>The nominal mesh has no surface.</source>
      <translation>名义网格没有表面。</translation>
    </message>
    <message>
      <source>The nominal of {v1} differs between {v2}: {v3}.</source>
      <translation>{v1} 的名义值在 {v2} 之间不同：{v3}。</translation>
    </message>
    <message>
      <source>The part was displaced by up to {v1} mm between the measurements: the spread includes clamping (reproducibility).</source>
      <translation>各次测量之间工件最多移动了 {v1} mm：离散包含装夹（复现性）。</translation>
    </message>
    <message>
      <source>The part was neither displaced nor tilted between the measurements ({v1} mm; a rotation about z is not considered): the spread does not include clamping.</source>
      <translation>各次测量之间工件既未移动也未倾斜（{v1} mm；不考虑绕 z 的旋转）：离散不包含装夹。</translation>
    </message>
    <message>
      <source>The part's temperature is not stated: its lengths are those at the temperature of the scan.</source>
      <translation>未给出工件温度：其长度为扫描温度下的长度。</translation>
    </message>
    <message>
      <source>The points span {v1} mm, the nominal {v2}</source>
      <translation>点的跨度为 {v1} mm，名义模型为 {v2}</translation>
    </message>
    <message>
      <source>The points span {v1} mm, the nominal {v2} mm: they are not of the same part.</source>
      <translation>点的范围为 {v1} mm，名义模型为 {v2} mm：不是同一工件。</translation>
    </message>
    <message>
      <source>The points span {v1}, the nominal {v2} mm</source>
      <translation>点的跨度为 {v1}，名义模型为 {v2} mm</translation>
    </message>
    <message>
      <source>The program has a {v1} {v2} already.</source>
      <translation>程序已有{v1} {v2}。</translation>
    </message>
    <message>
      <source>The program {v1} aligns by best fit, but there is no nominal mesh.</source>
      <translation>程序 {v1} 按最佳拟合对齐，但没有名义网格。</translation>
    </message>
    <message>
      <source>The section {v1} intersects neither the nominal nor measured points.</source>
      <translation>截面 {v1} 既不与名义模型也不与测量点相交。</translation>
    </message>
    <message>
      <source>The surface between the two clicks is not straight.</source>
      <translation>两次单击之间的表面不是直的。</translation>
    </message>
    <message>
      <source>The tolerance of {v1} {v2} is smaller than {v3} U ({v4} {v5}): this measurement can hardly prove it</source>
      <translation>公差 {v1} {v2} 小于 {v3} U ({v4} {v5})：此测量几乎无法证明</translation>
    </message>
    <message>
      <source>The two clicked faces are parallel, or the same one.</source>
      <translation>所单击的两个面平行，或为同一个面。</translation>
    </message>
    <message>
      <source>The two clicked faces do not meet in an edge.</source>
      <translation>所单击的两个面不相交成棱边。</translation>
    </message>
    <message>
      <source>The two clicks are less than {v1} mm apart.</source>
      <translation>两次单击的间距小于 {v1} mm。</translation>
    </message>
    <message>
      <source>The wall at the clicked place is not a cylinder.</source>
      <translation>单击处的壁面不是圆柱面。</translation>
    </message>
    <message>
      <source>The wall at the clicked place is not that of a slot with two round ends.</source>
      <translation>单击处的壁面不是带两个圆端的槽。</translation>
    </message>
    <message>
      <source>The width of the zone must be greater than 0.</source>
      <translation>公差带宽度必须大于 0。</translation>
    </message>
    <message>
      <source>The {v1} equal holes are not on a circle, in a row or on a grid.</source>
      <translation>这 {v1} 个相同的孔不在圆周、直线或网格上等距分布。</translation>
    </message>
    <message>
      <source>There are no distances from a {v1}.</source>
      <translation>没有到 {v1} 的距离。</translation>
    </message>
    <message>
      <source>There are no measured points to inspect.</source>
      <translation>没有可检测的测量点。</translation>
    </message>
    <message>
      <source>There is no alignment.</source>
      <translation>没有对齐。</translation>
    </message>
    <message>
      <source>There is no curved wall at the clicked place.</source>
      <translation>单击处没有曲面壁。</translation>
    </message>
    <message>
      <source>There is no flat face at a clicked place.</source>
      <translation>某个单击处没有平面。</translation>
    </message>
    <message>
      <source>There is no sharp edge of the CAD model near the clicked place.</source>
      <translation>单击处附近没有 CAD 模型的锐边。</translation>
    </message>
    <message>
      <source>These points have no normals, which show on which side the material is.</source>
      <translation>这些点没有法线，无法判断材料在哪一侧。</translation>
    </message>
    <message>
      <source>Too little was measured beside this edge.</source>
      <translation>该棱边旁的测量点太少。</translation>
    </message>
    <message>
      <source>Two datums are the same feature.</source>
      <translation>两个基准是同一要素。</translation>
    </message>
    <message>
      <source>Use a plane, sphere, cylinder or cone.</source>
      <translation>请使用平面、球、圆柱或圆锥。</translation>
    </message>
    <message>
      <source>a combined rotation and translation</source>
      <translation>旋转与平移的组合</translation>
    </message>
    <message>
      <source>a line, an axis or a second plane</source>
      <translation>直线、轴线或第二个平面</translation>
    </message>
    <message>
      <source>a plane</source>
      <translation>平面</translation>
    </message>
    <message>
      <source>a point, a centre or a third plane</source>
      <translation>点、中心或第三个平面</translation>
    </message>
    <message>
      <source>a radius</source>
      <translation>半径</translation>
    </message>
    <message>
      <source>a radius and an axis</source>
      <translation>半径和轴线</translation>
    </message>
    <message>
      <source>about the average blade, rotated onto it about the axis</source>
      <translation>相对于平均叶片，绕轴旋转与之重合</translation>
    </message>
    <message>
      <source>about the nominal, located by the alignment</source>
      <translation>相对于名义模型，由对齐定位</translation>
    </message>
    <message>
      <source>aligning the points to the nominal</source>
      <translation>正在将点与名义模型对齐</translation>
    </message>
    <message>
      <source>all points</source>
      <translation>所有点</translation>
    </message>
    <message>
      <source>associated axis over {v1} mm</source>
      <translation>拟合轴线，长 {v1} mm</translation>
    </message>
    <message>
      <source>associated centre</source>
      <translation>拟合中心</translation>
    </message>
    <message>
      <source>assumed: calibration ± {v1} mm and {v2} ppm of the length (k = 1)</source>
      <translation>假定：标定 ± {v1} mm 和长度的 {v2} ppm (k = 1)</translation>
    </message>
    <message>
      <source>assumed: position of each view ± {v1} mm (k = 1), as the cloud has no error model</source>
      <translation>假定：每个视图的位置 ± {v1} mm (k = 1)，因为点云没有误差模型</translation>
    </message>
    <message>
      <source>axes</source>
      <translation>轴线</translation>
    </message>
    <message>
      <source>axes and centres where a datum has a material condition</source>
      <translation>轴线和中心（当基准带有实体条件时）</translation>
    </message>
    <message>
      <source>best fit, {v1} positions about the axis</source>
      <translation>最佳拟合，绕轴 {v1} 个位置</translation>
    </message>
    <message>
      <source>best fit; the part fits upright and on its head equally well</source>
      <translation>最佳拟合；工件正放与倒放同样相符</translation>
    </message>
    <message>
      <source>centre of the zone offset {v1} into the material</source>
      <translation>公差带中心向材料内偏移 {v1}</translation>
    </message>
    <message>
      <source>centre of the zone offset {v1} out of the material</source>
      <translation>公差带中心向材料外偏移 {v1}</translation>
    </message>
    <message>
      <source>centres</source>
      <translation>中心</translation>
    </message>
    <message>
      <source>certified length of {v1} ± {v2} mm (k = 2){v3}</source>
      <translation>证书长度 {v1} ± {v2} mm (k = 2){v3}</translation>
    </message>
    <message>
      <source>coordinates as stated in the program</source>
      <translation>程序给定的坐标</translation>
    </message>
    <message>
      <source>corrected by {v1} mm by the certified length {v2}, U {v3} → {v4} mm</source>
      <translation>按证书长度 {v2} 修正 {v1} mm，U {v3} → {v4} mm</translation>
    </message>
    <message>
      <source>datum shift: {v1}, {v2} mm without shift</source>
      <translation>基准浮动：{v1}，无浮动时 {v2} mm</translation>
    </message>
    <message>
      <source>datum system {v1}</source>
      <translation>基准体系 {v1}</translation>
    </message>
    <message>
      <source>datums {v1}</source>
      <translation>基准 {v1}</translation>
    </message>
    <message>
      <source>deviation from the shape</source>
      <translation>形状偏差</translation>
    </message>
    <message>
      <source>diameter</source>
      <translation>直径</translation>
    </message>
    <message>
      <source>distances from the nominal</source>
      <translation>到名义模型的距离</translation>
    </message>
    <message>
      <source>end of the measured points</source>
      <translation>测量点的尽头</translation>
    </message>
    <message>
      <source>end of the points, displaced by half the stated loss of {v1} mm</source>
      <translation>点的尽头，移动所述损失 {v1} mm 的一半</translation>
    </message>
    <message>
      <source>explained by noise alone: one-sided, at most {v1} mm</source>
      <translation>仅由噪声即可解释：单侧，最多 {v1} mm</translation>
    </message>
    <message>
      <source>faces up to {v1} mm beside the edge</source>
      <translation>边两侧 {v1} mm 以内的面</translation>
    </message>
    <message>
      <source>fixes nothing new; it takes part in the least squares</source>
      <translation>不固定新的自由度；参与最小二乘</translation>
    </message>
    <message>
      <source>grown from seed to {v1} points within {v2} mm (noise {v3} mm)</source>
      <translation>由种子生长为 {v2} mm 以内的 {v1} 个点（噪声 {v3} mm）</translation>
    </message>
    <message>
      <source>inspection complete</source>
      <translation>检测完成</translation>
    </message>
    <message>
      <source>is a region of the nominal mesh, and the program has no `nominal`</source>
      <translation>是名义网格的区域，而程序没有 `nominal`</translation>
    </message>
    <message>
      <source>its edge is not round</source>
      <translation>其边缘不是圆的</translation>
    </message>
    <message>
      <source>its edge is not round, or was not measured</source>
      <translation>其边缘不是圆的，或没有测到</translation>
    </message>
    <message>
      <source>its edge was measured only partly</source>
      <translation>其边缘只测到一部分</translation>
    </message>
    <message>
      <source>its edge was not measured</source>
      <translation>其边缘没有测到</translation>
    </message>
    <message>
      <source>its points cover too small a part of the {v1} to determine it at their noise</source>
      <translation>其点只覆盖{v1}的很小部分，在其噪声下无法确定</translation>
    </message>
    <message>
      <source>its region did not converge</source>
      <translation>其区域未收敛</translation>
    </message>
    <message>
      <source>its seed lies on an edge, or the surface there is not a {v1}</source>
      <translation>其种子位于边上，或该处表面不是{v1}</translation>
    </message>
    <message>
      <source>least material</source>
      <translation>最小实体</translation>
    </message>
    <message>
      <source>least squares</source>
      <translation>最小二乘</translation>
    </message>
    <message>
      <source>length scale ± {v1} ppm (k = 1), from {v2}</source>
      <translation>长度比例 ± {v1} ppm (k = 1)，来自{v2}</translation>
    </message>
    <message>
      <source>local best fit ({v1})</source>
      <translation>局部最佳拟合（{v1}）</translation>
    </message>
    <message>
      <source>located by the alignment</source>
      <translation>由对齐定位</translation>
    </message>
    <message>
      <source>max of {count}</source>
      <translation>{count} 个的最大值</translation>
    </message>
    <message>
      <source>maximum material</source>
      <translation>最大实体</translation>
    </message>
    <message>
      <source>mean of {count}</source>
      <translation>{count} 个的平均值</translation>
    </message>
    <message>
      <source>means of {v1} mm cells</source>
      <translation>{v1} mm 单元的均值</translation>
    </message>
    <message>
      <source>medians over {v1} mm, {v2}</source>
      <translation>{v1} mm 上的中位数，{v2}</translation>
    </message>
    <message>
      <source>min of {count}</source>
      <translation>{count} 个的最小值</translation>
    </message>
    <message>
      <source>minimum zone</source>
      <translation>最小区域</translation>
    </message>
    <message>
      <source>no measured surface lies within {v1} mm of its seed</source>
      <translation>其种子 {v1} mm 内没有测量的表面</translation>
    </message>
    <message>
      <source>none: part frame taken as nominal frame</source>
      <translation>无：以工件坐标系为名义坐标系</translation>
    </message>
    <message>
      <source>of the features are found</source>
      <translation>的特征已找到</translation>
    </message>
    <message>
      <source>of the nominal and of the points match</source>
      <translation>名义模型与点相符的比例</translation>
    </message>
    <message>
      <source>only one side of the blade was measured</source>
      <translation>只测到叶片的一侧</translation>
    </message>
    <message>
      <source>only {v1} points around its seed form one surface, {v2} are needed</source>
      <translation>其种子周围只有 {v1} 个点构成一个表面，需要 {v2} 个</translation>
    </message>
    <message>
      <source>only {v1} points of one {v2} are connected to its seed, {v3} are needed</source>
      <translation>只有 {v1} 个{v2}的点与其种子相连，需要 {v3} 个</translation>
    </message>
    <message>
      <source>only {v1} points were measured around its seed, {v2} are needed</source>
      <translation>其种子周围只测量了 {v1} 个点，需要 {v2} 个</translation>
    </message>
    <message>
      <source>only {v1} points were measured on its edge</source>
      <translation>其边缘只测到 {v1} 个点</translation>
    </message>
    <message>
      <source>only {v1} points were measured on its edge, {v2} are needed</source>
      <translation>其边缘只测到 {v1} 个点，需要 {v2} 个</translation>
    </message>
    <message>
      <source>pitch circle</source>
      <translation>分布圆</translation>
    </message>
    <message>
      <source>planes, axes and centres</source>
      <translation>平面、轴线和中心</translation>
    </message>
    <message>
      <source>rotation about x</source>
      <translation>绕 x 旋转</translation>
    </message>
    <message>
      <source>rotation about y</source>
      <translation>绕 y 旋转</translation>
    </message>
    <message>
      <source>rotation about z</source>
      <translation>绕 z 旋转</translation>
    </message>
    <message>
      <source>spacing</source>
      <translation>间距</translation>
    </message>
    <message>
      <source>surface tilted</source>
      <translation>表面倾斜</translation>
    </message>
    <message>
      <source>taken as exact</source>
      <translation>视为准确</translation>
    </message>
    <message>
      <source>the alignment {v1} failed: {v2}</source>
      <translation>对齐 {v1} 失败：{v2}</translation>
    </message>
    <message>
      <source>the axis through {v1} sections</source>
      <translation>通过 {v1} 个截面的轴线</translation>
    </message>
    <message>
      <source>the blade continues there</source>
      <translation>叶片在那里延续</translation>
    </message>
    <message>
      <source>the fitted radius differs by {v1} mm from its nominal</source>
      <translation>拟合半径与名义值相差 {v1} mm</translation>
    </message>
    <message>
      <source>the fitted {v1} is tilted by {v2}° against its nominal</source>
      <translation>拟合的{v1}相对名义倾斜 {v2}°</translation>
    </message>
    <message>
      <source>the nominal of a {v1} does not follow from features</source>
      <translation>{v1}的名义值不能由特征得出</translation>
    </message>
    <message>
      <source>the part's coordinates</source>
      <translation>工件坐标系</translation>
    </message>
    <message>
      <source>the points do not cover the section from one edge to the other</source>
      <translation>这些点没有从一边到另一边覆盖截面</translation>
    </message>
    <message>
      <source>the points do not determine this value</source>
      <translation>这些点不能确定此值</translation>
    </message>
    <message>
      <source>the points of the patch do not determine a surface</source>
      <translation>该区块的点不能确定表面</translation>
    </message>
    <message>
      <source>the points of the patch do not surround the nominal point</source>
      <translation>该区块的点没有包围名义点</translation>
    </message>
    <message>
      <source>the region grown from its seed covers the whole part ({v1} of {v2} points)</source>
      <translation>由其种子生长的区域覆盖整个工件（{v2} 个点中的 {v1} 个）</translation>
    </message>
    <message>
      <source>the region grown from its seed is not a {v1}, or too small to determine one</source>
      <translation>由其种子生长的区域不是{v1}，或太小而不能确定</translation>
    </message>
    <message>
      <source>the surface at its seed is not a {v1}: it bends away by {v2} mm over the region</source>
      <translation>其种子处的表面不是{v1}：在该区域内弯离 {v2} mm</translation>
    </message>
    <message>
      <source>the worst of {v1} lines</source>
      <translation>{v1} 条线中最差者</translation>
    </message>
    <message>
      <source>the worst of {v1} sections</source>
      <translation>{v1} 个截面中最差者</translation>
    </message>
    <message>
      <source>translation along x</source>
      <translation>沿 x 平移</translation>
    </message>
    <message>
      <source>translation along y</source>
      <translation>沿 y 平移</translation>
    </message>
    <message>
      <source>translation along z</source>
      <translation>沿 z 平移</translation>
    </message>
    <message>
      <source>which of {v1} positions about the axis</source>
      <translation>绕轴 {v1} 个位置中的哪一个</translation>
    </message>
    <message>
      <source>{v1} and {v2} are blades of different sections: their pitch is undefined</source>
      <translation>{v1} 与 {v2} 是不同截面的叶片：其节距没有定义</translation>
    </message>
    <message>
      <source>{v1} and {v2} are the same measurement: all values agree to the last digit.</source>
      <translation>{v1} 与 {v2} 是同一次测量：所有值直到末位都一致。</translation>
    </message>
    <message>
      <source>{v1} and {v2} are {v3}° from parallel (limit {v4}°): their distance is undefined</source>
      <translation>{v1} 与 {v2} 偏离平行 {v3}°（限值 {v4}°）：其距离没有定义</translation>
    </message>
    <message>
      <source>{v1} and {v2} do not face opposite directions ({v3}° off): their thickness is undefined</source>
      <translation>{v1} 与 {v2} 不是相对朝向（偏 {v3}°）：其厚度没有定义</translation>
    </message>
    <message>
      <source>{v1} and {v2} do not fix {v3}, and the surface point {v4} fixes a translation only. Use an axis or plane as the line, or reference points</source>
      <translation>{v1} 与 {v2} 不能固定 {v3}，而表面点 {v4} 只固定一个平移。请用轴线或平面作为直线，或用参考点</translation>
    </message>
    <message>
      <source>{v1} and {v2} face opposite directions: measure a distance, not a step</source>
      <translation>{v1} 与 {v2} 朝向相反：请测量距离，而非台阶</translation>
    </message>
    <message>
      <source>{v1} and {v2} more</source>
      <translation>{v1}，另有 {v2} 个</translation>
    </message>
    <message>
      <source>{v1} cannot be the datum of its own tolerance.</source>
      <translation>{v1} 不能作为自身公差的基准。</translation>
    </message>
    <message>
      <source>{v1} constructed features: {v2} … {v3}</source>
      <translation>{v1} 个构造特征：{v2} … {v3}</translation>
    </message>
    <message>
      <source>{v1} dimensions, chi-square test at a level of {v2} in all</source>
      <translation>{v1} 个尺寸，卡方检验，总显著性水平 {v2}</translation>
    </message>
    <message>
      <source>{v1} do not have the same dimensions: only one has {v2}.</source>
      <translation>{v1} 的尺寸不相同：只有一个有 {v2}。</translation>
    </message>
    <message>
      <source>{v1} features: {v2} points, {v3} rejected</source>
      <translation>{v1} 个特征：{v2} 个点，{v3} 个被剔除</translation>
    </message>
    <message>
      <source>{v1} has no dimensions.</source>
      <translation>{v1} 没有尺寸。</translation>
    </message>
    <message>
      <source>{v1} has no nominal position</source>
      <translation>{v1} 没有名义位置</translation>
    </message>
    <message>
      <source>{v1} is a constructed feature without a length for its {v2}</source>
      <translation>{v1} 是构造特征，没有其{v2}的长度</translation>
    </message>
    <message>
      <source>{v1} is a constructed feature without a measured surface</source>
      <translation>{v1} 是没有测量表面的构造特征</translation>
    </message>
    <message>
      <source>{v1} is a constructed line without a measured surface</source>
      <translation>{v1} 是没有测量表面的构造直线</translation>
    </message>
    <message>
      <source>{v1} is a plane: its straightness needs `along`, the direction of the lines</source>
      <translation>{v1} 是平面：其直线度需要 `along`，即直线的方向</translation>
    </message>
    <message>
      <source>{v1} is a surface point: a datum must be a plane, an axis or a centre</source>
      <translation>{v1} 是表面点：基准必须是平面、轴线或中心</translation>
    </message>
    <message>
      <source>{v1} is a {v2} and has no cone angle</source>
      <translation>{v1} 是{v2}，没有锥角</translation>
    </message>
    <message>
      <source>{v1} is a {v2} and has no direction</source>
      <translation>{v1} 是{v2}，没有方向</translation>
    </message>
    <message>
      <source>{v1} is a {v2} and has no radius</source>
      <translation>{v1} 是{v2}，没有半径</translation>
    </message>
    <message>
      <source>{v1} is a {v2} and has no slot {v3}</source>
      <translation>{v1} 是{v2}，没有槽{v3}</translation>
    </message>
    <message>
      <source>{v1} is a {v2}, which cannot be a datum for {v3}</source>
      <translation>{v1} 是{v2}，不能作为{v3}的基准</translation>
    </message>
    <message>
      <source>{v1} is a {v2}, which cannot be a datum for {v3}: it must be a {v4}.</source>
      <translation>{v1} 是 {v2}，不能作为 {v3} 的基准：必须是 {v4}。</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: 3-2-1 needs {v3} there</source>
      <translation>{v1} 是{v2}：3-2-1 在该处需要{v3}</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: a material condition of a datum requires a measured cylinder</source>
      <translation>{v1} 是{v2}：基准的实体要求需要测量的圆柱</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: a material condition requires a measured cylinder</source>
      <translation>{v1} 是{v2}：实体要求需要测量的圆柱</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: a step is defined between planes</source>
      <translation>{v1} 是{v2}：台阶定义在平面之间</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: as a reference point it needs `along` or `lock`, its constrained directions</source>
      <translation>{v1} 是{v2}：作为参考点，它需要 `along` 或 `lock`，即其受约束的方向</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: it has no nominal surface</source>
      <translation>{v1} 是{v2}：它没有名义表面</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: position is defined for {v3}</source>
      <translation>{v1} 是{v2}：位置度定义于{v3}</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: run-out requires a measured cylinder or plane</source>
      <translation>{v1} 是{v2}：跳动需要测量的圆柱或平面</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: run-out requires an axis as its datum</source>
      <translation>{v1} 是{v2}：跳动需要轴线作为基准</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: {v3} is defined for a {v4}</source>
      <translation>{v1} 是{v2}：{v3}定义于{v4}</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: {v3} is defined for a {v4}.</source>
      <translation>{v1} 是 {v2}：{v3} 只适用于 {v4}。</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: {v3} is defined for planes and axes</source>
      <translation>{v1} 是{v2}：{v3}定义于平面和轴线</translation>
    </message>
    <message>
      <source>{v1} is a {v2}: {v3} is defined for {v4}</source>
      <translation>{v1} 是{v2}：{v3}的定义对象为 {v4}</translation>
    </message>
    <message>
      <source>{v1} is inclined by {v2}° to {v3}: their distance is undefined</source>
      <translation>{v1} 对 {v3} 倾斜 {v2}°：其距离没有定义</translation>
    </message>
    <message>
      <source>{v1} is not equal to {v2} in shape, size and direction.</source>
      <translation>{v1} 与 {v2} 的形状、尺寸和方向不相同。</translation>
    </message>
    <message>
      <source>{v1} is used as a datum, which needs a letter.</source>
      <translation>{v1} 被用作基准，必须有字母。</translation>
    </message>
    <message>
      <source>{v1} is used by {v2}.</source>
      <translation>{v1} 被 {v2} 使用。</translation>
    </message>
    <message>
      <source>{v1} is {v2}° from the axis of {v3}: its run-out is undefined</source>
      <translation>{v1} 与 {v3} 的轴线相差 {v2}°：其跳动没有定义</translation>
    </message>
    <message>
      <source>{v1} is {v2}° from {v3} to {v4}: check the feature and its datum</source>
      <translation>{v1} 与{v4}的{v3}相差 {v2}°：请检查特征及其基准</translation>
    </message>
    <message>
      <source>{v1} mm less {v2} mm by noise</source>
      <translation>{v1} mm，扣除噪声引起的 {v2} mm</translation>
    </message>
    <message>
      <source>{v1} needs a name.</source>
      <translation>{v1} 需要名称。</translation>
    </message>
    <message>
      <source>{v1} play {v2} mm</source>
      <translation>{v1} 间隙 {v2} mm</translation>
    </message>
    <message>
      <source>{v1} positions about the axis are indistinguishable ({v2}); the one with the smallest rotation was chosen</source>
      <translation>{v1}绕轴的位置无法区分（{v2}）；已选择旋转最小的一个</translation>
    </message>
    <message>
      <source>{v1} regions</source>
      <translation>{v1} 个区域</translation>
    </message>
    <message>
      <source>{v1} to {v2} mm rms</source>
      <translation>{v1} 至 {v2} mm rms</translation>
    </message>
    <message>
      <source>{v1} was not measured at its section</source>
      <translation>{v1} 在其截面处未测量</translation>
    </message>
    <message>
      <source>{v1} were inspected with different programs: {v2}.</source>
      <translation>{v1} 按不同程序检测：{v2}。</translation>
    </message>
    <message>
      <source>{v1} {v2} and {v3} {v4}</source>
      <translation>{v1} {v2} 和 {v3} {v4}</translation>
    </message>
    <message>
      <source>{v1}, axial, {v2} rings</source>
      <translation>{v1}，轴向，{v2} 个圆环</translation>
    </message>
    <message>
      <source>{v1}, face</source>
      <translation>{v1}，面</translation>
    </message>
    <message>
      <source>{v1}, face {v2}</source>
      <translation>{v1}，面 {v2}</translation>
    </message>
    <message>
      <source>{v1}, loss</source>
      <translation>{v1}，损失</translation>
    </message>
    <message>
      <source>{v1}, radial, {v2} sections</source>
      <translation>{v1}，径向，{v2} 个截面</translation>
    </message>
    <message>
      <source>{v1}: `along` is perpendicular to the plane, which has no lines in that direction</source>
      <translation>{v1}：`along` 垂直于平面，平面在该方向没有直线</translation>
    </message>
    <message>
      <source>{v1}: a blade profile needs a nominal mesh, and the program has none</source>
      <translation>{v1}：叶片轮廓需要名义网格，而程序没有</translation>
    </message>
    <message>
      <source>{v1}: a mid-plane needs two planes, {v2} and {v3} are not</source>
      <translation>{v1}：中间平面需要两个平面，而 {v2} 和 {v3} 不是</translation>
    </message>
    <message>
      <source>{v1}: a pitch needs at least two measured blades of one section</source>
      <translation>{v1}：节距至少需要同一截面的两个已测叶片</translation>
    </message>
    <message>
      <source>{v1}: a point on an axis needs an axis, and the plane from which its distance counts</source>
      <translation>{v1}：轴线上的点需要轴线，以及计算其距离的平面</translation>
    </message>
    <message>
      <source>{v1}: a projection needs a point or axis, and the plane it is projected onto</source>
      <translation>{v1}：投影需要点或轴线，以及投影所至的平面</translation>
    </message>
    <message>
      <source>{v1}: an average blade needs at least two measured blades of this section</source>
      <translation>{v1}：平均叶片至少需要此截面的两个已测叶片</translation>
    </message>
    <message>
      <source>{v1}: an intersection needs a plane, and a plane or an axis</source>
      <translation>{v1}：相交需要一个平面，以及一个平面或轴线</translation>
    </message>
    <message>
      <source>{v1}: an intersection of three needs planes, {v2} is a {v3}</source>
      <translation>{v1}：三者相交需要平面，而 {v2} 是{v3}</translation>
    </message>
    <message>
      <source>{v1}: an offset needs a plane, {v2} is a {v3}</source>
      <translation>{v1}：偏置需要平面，而 {v2} 是{v3}</translation>
    </message>
    <message>
      <source>{v1}: constructed</source>
      <translation>{v1}：构造的</translation>
    </message>
    <message>
      <source>{v1}: its axis has only {v2} complete sections, {v3} are needed</source>
      <translation>{v1}：其轴线只有 {v2} 个完整截面，需要 {v3} 个</translation>
    </message>
    <message>
      <source>{v1}: its points are on one line and determine no circle</source>
      <translation>{v1}：其点在一条直线上，不能确定圆</translation>
    </message>
    <message>
      <source>{v1}: its points are on one line and determine no plane</source>
      <translation>{v1}：其点在一条直线上，不能确定平面</translation>
    </message>
    <message>
      <source>{v1}: its points coincide</source>
      <translation>{v1}：其点重合</translation>
    </message>
    <message>
      <source>{v1}: its points cover too small a segment to determine {v2} at their noise</source>
      <translation>{v1}：其点覆盖的弧段太小，在其噪声下无法确定{v2}</translation>
    </message>
    <message>
      <source>{v1}: no line is long enough for {v2} cells of {v3} mm</source>
      <translation>{v1}：没有直线足够长以容纳 {v2} 个 {v3} mm 的单元</translation>
    </message>
    <message>
      <source>{v1}: no section is measured over more than {v2} of its circumference, {v3} are needed</source>
      <translation>{v1}：没有截面在其圆周的 {v2} 以上被测量，需要 {v3}</translation>
    </message>
    <message>
      <source>{v1}: not found</source>
      <translation>{v1}：未找到</translation>
    </message>
    <message>
      <source>{v1}: not measured in {v2}; evaluated from {v3} of {v4} measurements.</source>
      <translation>{v1}：在 {v2} 中未测量；由 {v4} 次测量中的 {v3} 次评定。</translation>
    </message>
    <message>
      <source>{v1}: only {v2} cells have enough points, {v3} are needed</source>
      <translation>{v1}：只有 {v2} 个单元有足够的点，需要 {v3} 个</translation>
    </message>
    <message>
      <source>{v1}: only {v2} of the circumference is measured, {v3} are needed</source>
      <translation>{v1}：只测量了圆周的 {v2}，需要 {v3}</translation>
    </message>
    <message>
      <source>{v1}: only {v2} points were measured there, {v3} are needed</source>
      <translation>{v1}：该处只测到 {v2} 个点，需要 {v3} 个</translation>
    </message>
    <message>
      <source>{v1}: only {v2} segments of its sides have enough points, {v3} are needed</source>
      <translation>{v1}：其侧边只有 {v2} 段有足够的点，需要 {v3} 段</translation>
    </message>
    <message>
      <source>{v1}: symmetry needs two planes, two parallel axes, or two centres</source>
      <translation>{v1}：对称度需要两个平面、两条平行轴线或两个中心</translation>
    </message>
    <message>
      <source>{v1}: the axis runs parallel to the plane and does not meet it</source>
      <translation>{v1}：轴线与平面平行，不相交</translation>
    </message>
    <message>
      <source>{v1}: the axis {v2} is perpendicular to {v3}; its projection is a point: use their intersection</source>
      <translation>{v1}：轴线 {v2} 垂直于 {v3}；其投影是一个点：请用它们的交点</translation>
    </message>
    <message>
      <source>{v1}: the nominal looks like {v2}.</source>
      <translation>{v1}：名义模型看来像 {v2}。</translation>
    </message>
    <message>
      <source>{v1}: the planes are parallel and do not meet</source>
      <translation>{v1}：两平面平行，不相交</translation>
    </message>
    <message>
      <source>{v1}: the points along the edge are too few or too uneven, {v2} are needed</source>
      <translation>{v1}：沿边的点太少或太不均匀，需要 {v2} 个</translation>
    </message>
    <message>
      <source>{v1}: the points look like {v2}.</source>
      <translation>{v1}：这些点看来像 {v2}。</translation>
    </message>
    <message>
      <source>{v1}: the standard deviation {v2} {v3} contradicts the stated uncertainty U = {v4} {v5} (chi-square test, {v6}): something varies that the uncertainty budget does not contain, for example clamping, temperature or the part itself.</source>
      <translation>{v1}：标准差 {v2} {v3} 与给定的不确定度 U = {v4} {v5} 矛盾（卡方检验，{v6}）：有不确定度预算未包含的因素在变化，例如装夹、温度或工件本身。</translation>
    </message>
    <message>
      <source>{v1}: the three planes do not meet in one point: two are parallel, or all contain one direction</source>
      <translation>{v1}：三平面不交于一点：两个平行，或都含同一方向</translation>
    </message>
    <message>
      <source>{v1}: the {v2} is not determined, most trials with simulated noise fail</source>
      <translation>{v1}：{v2}不能确定，多数模拟噪声试验失败</translation>
    </message>
    <message>
      <source>{v1}: {v2} and {v3} are {v4} mm from one {v5}: they cannot be one datum</source>
      <translation>{v1}：{v2} 与 {v3} 偏离同一{v5} {v4} mm：不能作为一个基准</translation>
    </message>
    <message>
      <source>{v1}: {v2} and {v3} are {v4}° from parallel and have no axis of symmetry</source>
      <translation>{v1}：{v2} 与 {v3} 偏离平行 {v4}°，没有对称轴</translation>
    </message>
    <message>
      <source>{v1}: {v2} and {v3} are {v4}° from parallel: they cannot be one datum</source>
      <translation>{v1}：{v2} 与 {v3} 不平行，相差 {v4}°：不能作为一个基准</translation>
    </message>
    <message>
      <source>{v1}: {v2} and {v3} cannot be one datum, as two axes in line, two faces in one plane or two centres can</source>
      <translation>{v1}：{v2} 与 {v3} 不能作为一个基准；共线的两条轴线、共面的两个平面或两个中心点可以</translation>
    </message>
    <message>
      <source>{v1}: {v2} is a {v3} and no point: intersect or project it first</source>
      <translation>{v1}：{v2} 是{v3}而非点：请先求交或投影</translation>
    </message>
    <message>
      <source>{v1}: {v2} is undefined, as {v3} ({v4} end)</source>
      <translation>{v1}：{v2}没有定义，因为 {v3}（{v4}端）</translation>
    </message>
    <message>
      <source>{v1}: {v2} mm bonus on {v3} mm</source>
      <translation>{v1}：在 {v3} mm 上补偿 {v2} mm</translation>
    </message>
    <message>
      <source>{v1}: {v2} points, {v3} rejected</source>
      <translation>{v1}：{v2} 个点，{v3} 个被剔除</translation>
    </message>
    <message>
      <source>{v1}; border: {v2}</source>
      <translation>{v1}；边界：{v2}</translation>
    </message>
    <message>
      <source>{v1}; measured {v2} ± {v3} mm. Other lengths are corrected by what it is off.</source>
      <translation>{v1}；实测 {v2} ± {v3} mm。其他长度按其偏差修正。</translation>
    </message>
    <message>
      <source>{v1}; not measured, so that it corrects nothing.</source>
      <translation>{v1}；未测得，因此不作修正。</translation>
    </message>
    <message>
      <source>{v1}; nothing is corrected. {v2}.</source>
      <translation>{v1}；不作修正。{v2}。</translation>
    </message>
    <message>
      <source>± {v1} ppm (k = 2)</source>
      <translation>± {v1} ppm (k = 2)</translation>
    </message>
  </context>
  <context>
    <name>core.language</name>
    <message>
      <source>Correct this translation.</source>
      <translation>请更正此翻译。</translation>
    </message>
    <message>
      <source>Install the program anew.</source>
      <translation>请重新安装程序。</translation>
    </message>
    <message>
      <source>There is no language {v1}.</source>
      <translation>没有语言 {v1}。</translation>
    </message>
    <message>
      <source>{v1} is not a file of Qt Linguist: {v2}.</source>
      <translation>{v1} 不是 Qt Linguist 文件：{v2}。</translation>
    </message>
    <message>
      <source>{v1}: “{v2}” has other placeholders than “{v3}”.</source>
      <translation>{v1}：“{v2}”的占位符与“{v3}”不同。</translation>
    </message>
  </context>
  <context>
    <name>core.main_window</name>
    <message>
      <source>dark</source>
      <translation>深色</translation>
    </message>
    <message>
      <source>light</source>
      <translation>浅色</translation>
    </message>
  </context>
  <context>
    <name>core.pages</name>
    <message>
      <source>A dimension needs a name.</source>
      <translation>尺寸需要名称。</translation>
    </message>
    <message>
      <source>{v1} does not draw</source>
      <translation>{v1} 不作绘制</translation>
    </message>
  </context>
  <context>
    <name>core.peers</name>
    <message>
      <source>Start it by `measureapp rig peers`, and use the rig description that it has just written.</source>
      <translation>请用 `measureapp rig peers` 启动，并使用其刚写出的测量系统描述。</translation>
    </message>
    <message>
      <source>The virtual cell at {v1} does not answer: {v2}.</source>
      <translation>{v1} 处的虚拟测量单元没有应答：{v2}。</translation>
    </message>
  </context>
  <context>
    <name>core.pipeline</name>
    <message>
      <source>Add it on the page Inspect.</source>
      <translation>请在“检测”页添加。</translation>
    </message>
    <message>
      <source>Add one of them to the recording.</source>
      <translation>请将其中之一添加到录制。</translation>
    </message>
    <message>
      <source>Calibrate again, or set when_exceeded = "warn" in the rig's calibration_rules.</source>
      <translation>请重新标定，或在测量系统的 calibration_rules 中设置 when_exceeded = "warn"。</translation>
    </message>
    <message>
      <source>Calibrate first: measureapp process PROJECT.</source>
      <translation>请先标定：measureapp process PROJECT。</translation>
    </message>
    <message>
      <source>Calibrate into a new project, or use the rig description with which this one was made.</source>
      <translation>请标定到新项目，或使用创建此标定的测量系统描述。</translation>
    </message>
    <message>
      <source>Calibrate into a new project.</source>
      <translation>请标定到新项目。</translation>
    </message>
    <message>
      <source>Calibrate the rig first.</source>
      <translation>请先标定测量系统。</translation>
    </message>
    <message>
      <source>Camera {v1} does not support an exposure of {v2} µs.</source>
      <translation>相机 {v1} 不支持 {v2} µs 的曝光。</translation>
    </message>
    <message>
      <source>Check that head and part are fixed, and {v1}</source>
      <translation>请检查测头和工件是否固定，并{v1}</translation>
    </message>
    <message>
      <source>Check the guide for play, and {v1}</source>
      <translation>请检查导轨的间隙，并{v1}</translation>
    </message>
    <message>
      <source>Check the images; change exposures or viewpoints.</source>
      <translation>请检查图像；更改曝光或视点。</translation>
    </message>
    <message>
      <source>Check the table for play, and {v1}</source>
      <translation>请检查转台的间隙，并{v1}</translation>
    </message>
    <message>
      <source>Check whether part or head moved between the views and whether the calibration is of this rig; the images are kept.</source>
      <translation>请检查工件或测头在视图之间是否移动，以及标定是否属于此测量系统；图像已保留。</translation>
    </message>
    <message>
      <source>Choose a new or an empty folder for the joined project.</source>
      <translation>请为合并项目选择新的或空的文件夹。</translation>
    </message>
    <message>
      <source>Choose a new or an empty folder for the project.</source>
      <translation>请为项目选择新的或空的文件夹。</translation>
    </message>
    <message>
      <source>Choose another folder, or delete that one first.</source>
      <translation>请选择另一文件夹，或先删除该文件夹。</translation>
    </message>
    <message>
      <source>Choose the views in the project of their set-up, then compute this one again: measureapp process PROJECT.</source>
      <translation>请在其装夹的项目中选择视图，然后重新计算此项目：measureapp process PROJECT。</translation>
    </message>
    <message>
      <source>Choose {v1}…{v2} µs.</source>
      <translation>请选择 {v1}…{v2} µs。</translation>
    </message>
    <message>
      <source>Close other programs, raise the memory limit of the container, or use a computer with more memory.</source>
      <translation>请关闭其他程序、提高容器的内存限制，或使用内存更大的计算机。</translation>
    </message>
    <message>
      <source>Cloud of {v1}</source>
      <translation>{v1} 的点云</translation>
    </message>
    <message>
      <source>Collisions and coverage were checked for the pose of the plan: stop, and place the part as planned or correct the pose</source>
      <translation>碰撞和覆盖率是按计划中的位姿检查的：请停止，并按计划放置工件或更正位姿</translation>
    </message>
    <message>
      <source>Compute it again: measureapp process {v1}.</source>
      <translation>请重新计算：measureapp process {v1}。</translation>
    </message>
    <message>
      <source>Compute its clouds by `measureapp process PROJECT`, or record what is missing.</source>
      <translation>请用 `measureapp process PROJECT` 计算其点云，或录制缺少的内容。</translation>
    </message>
    <message>
      <source>Connect its disk again or restore the folder, then continue the scan.</source>
      <translation>请重新接上其磁盘或恢复文件夹，然后继续扫描。</translation>
    </message>
    <message>
      <source>Correct the read-backs, and process the images again; they are kept.</source>
      <translation>请更正读回，然后重新处理图像；图像已保留。</translation>
    </message>
    <message>
      <source>Disconnect the rig first; it is then connected as the task needs it.</source>
      <translation>请先断开测量系统；之后会按任务需要连接。</translation>
    </message>
    <message>
      <source>Draw one camera only: --camera.</source>
      <translation>请只绘制一台相机：--camera。</translation>
    </message>
    <message>
      <source>Give ROW,COLUMN,ROW,COLUMN of two corners within {v1} rows and {v2} columns.</source>
      <translation>请给出 {v1} 行和 {v2} 列内两个角的 行,列,行,列。</translation>
    </message>
    <message>
      <source>Give a TOML file such as those in resources/worlds.</source>
      <translation>请给出 TOML 文件，如 resources/worlds 中的文件。</translation>
    </message>
    <message>
      <source>Give all projects the same nominal, and measure them again.</source>
      <translation>请给所有项目相同的名义模型，然后重新测量。</translation>
    </message>
    <message>
      <source>Give all projects the same program, and measure them again: measureapp process PROJECT.</source>
      <translation>请给所有项目相同的程序，然后重新测量：measureapp process PROJECT。</translation>
    </message>
    <message>
      <source>Give it one on the Inspect page, and measure again.</source>
      <translation>请在“检测”页给它一个，并重新测量。</translation>
    </message>
    <message>
      <source>Give one: --rig RIG.</source>
      <translation>请给出一个：--rig RIG。</translation>
    </message>
    <message>
      <source>Import one with `measureapp import`.</source>
      <translation>请用 `measureapp import` 导入一个。</translation>
    </message>
    <message>
      <source>Install the program again.</source>
      <translation>请重新安装程序。</translation>
    </message>
    <message>
      <source>Its processing did not end. Its images are stored: process the project again.</source>
      <translation>其处理没有结束。图像已存储：请重新处理该项目。</translation>
    </message>
    <message>
      <source>Keep fewer points: a larger --every.</source>
      <translation>请保留较少的点：增大 --every。</translation>
    </message>
    <message>
      <source>Let it warm up, and {v1}</source>
      <translation>请让其预热，并{v1}</translation>
    </message>
    <message>
      <source>Measure it first: measureapp process {v1}.</source>
      <translation>请先测量：measureapp process {v1}。</translation>
    </message>
    <message>
      <source>Name each project once; a spread needs independent scans.</source>
      <translation>每个项目只能列出一次；分散性需要独立的扫描。</translation>
    </message>
    <message>
      <source>Name each set-up once.</source>
      <translation>每次装夹只能列出一次。</translation>
    </message>
    <message>
      <source>Name one of {v1}.</source>
      <translation>请指定以下之一：{v1}。</translation>
    </message>
    <message>
      <source>Name one: --nominal FILE.</source>
      <translation>请指定：--nominal FILE。</translation>
    </message>
    <message>
      <source>Name projects of one part; if this is one part under two names, add --one-part.</source>
      <translation>请指定同一工件的项目；若为同一工件的两个名称，请加 --one-part。</translation>
    </message>
    <message>
      <source>Name the projects of its set-ups instead.</source>
      <translation>请改为指定其各次装夹的项目。</translation>
    </message>
    <message>
      <source>Name their cameras.json.</source>
      <translation>请指定其 cameras.json。</translation>
    </message>
    <message>
      <source>No camera detects the {v1}</source>
      <translation>没有相机检测到{v1}</translation>
    </message>
    <message>
      <source>Not calibrated: {v1}. The {v2} may move between the viewpoints, so each cloud stays in its camera frame.</source>
      <translation>未标定：{v1}。{v2}可能在视点之间移动，因此每片点云留在其相机坐标系中。</translation>
    </message>
    <message>
      <source>Only one set-up is named.</source>
      <translation>只指定了一次装夹。</translation>
    </message>
    <message>
      <source>Plan the scan first.</source>
      <translation>请先规划扫描。</translation>
    </message>
    <message>
      <source>Plan the scan first: a template is a start for scans.</source>
      <translation>请先规划扫描：模板是扫描的起点。</translation>
    </message>
    <message>
      <source>Processing {v1} needs about {v2} of memory ({v3}), and {v4} are available.</source>
      <translation>处理 {v1} 约需 {v2} 内存（{v3}），可用内存为 {v4}。</translation>
    </message>
    <message>
      <source>Put the board on its stand in the centre of the table, tilted towards the robot, and check light, lens caps and the board's settings.</source>
      <translation>请将标定板放在转台中央的支架上并朝机器人倾斜，检查光照、镜头盖和标定板的设置。</translation>
    </message>
    <message>
      <source>Raw images of {v1}</source>
      <translation>{v1} 的原始图像</translation>
    </message>
    <message>
      <source>Raw images of {v1} viewpoints {v2}: {v3} MB freed.</source>
      <translation>{v1} 个视点的原始图像{v2}：释放 {v3} MB。</translation>
    </message>
    <message>
      <source>Recompute it: measureapp process {v1}.</source>
      <translation>请重新计算：measureapp process {v1}。</translation>
    </message>
    <message>
      <source>Recordings of other rigs have none; plan a new scan.</source>
      <translation>其他测量系统的录制没有；请规划新的扫描。</translation>
    </message>
    <message>
      <source>Restore it from a backup, or join the set-ups again.</source>
      <translation>请从备份恢复，或重新合并各次装夹。</translation>
    </message>
    <message>
      <source>Scan first, or recompute it: measureapp process PROJECT.</source>
      <translation>请先扫描，或重新计算：measureapp process PROJECT。</translation>
    </message>
    <message>
      <source>Scan the part first, or restore the project's folder `stacks`.</source>
      <translation>请先扫描工件，或恢复项目的文件夹 `stacks`。</translation>
    </message>
    <message>
      <source>Scan the part first: measureapp scan.</source>
      <translation>请先扫描工件：measureapp scan。</translation>
    </message>
    <message>
      <source>Scan the part, or compute them from stored images: measureapp process PROJECT.</source>
      <translation>请扫描工件，或由存储的图像计算：measureapp process PROJECT。</translation>
    </message>
    <message>
      <source>Scan the part, or compute them: measureapp process PROJECT.</source>
      <translation>请扫描工件，或计算：measureapp process PROJECT。</translation>
    </message>
    <message>
      <source>Stored are: {v1}.</source>
      <translation>已存储：{v1}。</translation>
    </message>
    <message>
      <source>Take them first, or give a calibration.</source>
      <translation>请先拍摄，或给出标定。</translation>
    </message>
    <message>
      <source>The axes and the images disagree: {v1} of the points of a view lie in front of what other views see there, by {v2} mm in the middle.</source>
      <translation>轴与图像不符：某视图有 {v1} 的点位于其他视图在该处所见表面之前，居中值为 {v2} mm。</translation>
    </message>
    <message>
      <source>The calibration of {v1} is needed to match their images.</source>
      <translation>匹配其图像需要 {v1} 的标定。</translation>
    </message>
    <message>
      <source>The connected rig ({v1}) is described differently than the rig of this task ({v2}).</source>
      <translation>已连接测量系统 ({v1}) 的描述与此任务的测量系统 ({v2}) 不同。</translation>
    </message>
    <message>
      <source>The images of {v1}{v2} were stored in {v3} and are gone.</source>
      <translation>{v1}{v2} 的图像曾存储在 {v3}，现已不在。</translation>
    </message>
    <message>
      <source>The part is not where the plan assumes it ({v1}): half of the points of the first cloud are more than {v2} mm off.</source>
      <translation>工件不在计划所假定的位置（{v1}）：第一片点云有一半的点偏离超过 {v2} mm。</translation>
    </message>
    <message>
      <source>The part program {v1} has no rig.</source>
      <translation>工件程序 {v1} 没有测量系统。</translation>
    </message>
    <message>
      <source>The patterns span {v1} columns, {v2} has {v3}.</source>
      <translation>图案覆盖 {v1} 列，{v2} 有 {v3} 列。</translation>
    </message>
    <message>
      <source>The plan has no viewpoint {v1}.</source>
      <translation>计划没有视点 {v1}。</translation>
    </message>
    <message>
      <source>The region {v1},{v2},{v3},{v4} is not inside the images of camera {v5}.</source>
      <translation>区域 {v1},{v2},{v3},{v4} 不在相机 {v5} 的图像内。</translation>
    </message>
    <message>
      <source>The sample project {v1} is damaged: {v2}.</source>
      <translation>示例项目 {v1} 已损坏：{v2}。</translation>
    </message>
    <message>
      <source>The sample would have {v1} MB.</source>
      <translation>示例将有 {v1} MB。</translation>
    </message>
    <message>
      <source>The set-ups have no nominal to be joined by.</source>
      <translation>各次装夹没有可用于合并的名义模型。</translation>
    </message>
    <message>
      <source>The viewpoints have no read-backs, so each cloud stays in its camera frame.</source>
      <translation>这些视点没有读回，因此每片点云留在其相机坐标系中。</translation>
    </message>
    <message>
      <source>There are no images of the board.</source>
      <translation>没有标定板图像。</translation>
    </message>
    <message>
      <source>There is no sample project {v1}.</source>
      <translation>没有示例项目 {v1}。</translation>
    </message>
    <message>
      <source>There is no set-up {v1}.</source>
      <translation>没有装夹 {v1}。</translation>
    </message>
    <message>
      <source>There is no view {v1}.</source>
      <translation>没有视图 {v1}。</translation>
    </message>
    <message>
      <source>There is nothing to stitch: {v1}.{v2}</source>
      <translation>没有可拼接的内容：{v1}。{v2}</translation>
    </message>
    <message>
      <source>Use --resume to take only the missing viewpoints, or scan into a new project.</source>
      <translation>请用 --resume 只拍摄缺少的视点，或扫描到新项目。</translation>
    </message>
    <message>
      <source>Use a stack taken by a rig.</source>
      <translation>请使用测量系统拍摄的图像组。</translation>
    </message>
    <message>
      <source>all unsaturated exposures, weighted by inverse variance</source>
      <translation>全部未饱和曝光，按方差倒数加权</translation>
    </message>
    <message>
      <source>assumed: full well {full_well} e, read noise {read_noise} e</source>
      <translation>假定：满阱容量 {full_well} e，读出噪声 {read_noise} e</translation>
    </message>
    <message>
      <source>axes that move otherwise than calibrated, such as run-out of the table, or a part that moved</source>
      <translation>轴的运动与标定不同，如转台跳动，或工件移动过</translation>
    </message>
    <message>
      <source>blur or light that depends on the direction of the surface, such as a part less sharp than the board</source>
      <translation>与表面方向有关的模糊或光照，如工件不如标定板清晰</translation>
    </message>
    <message>
      <source>calibrate the rig again.</source>
      <translation>重新标定测量系统。</translation>
    </message>
    <message>
      <source>camera pixel</source>
      <translation>相机像素</translation>
    </message>
    <message>
      <source>cameras or projector that drift while they warm up</source>
      <translation>相机或投影仪在预热时漂移</translation>
    </message>
    <message>
      <source>compiling: {v1}</source>
      <translation>正在编译：{v1}</translation>
    </message>
    <message>
      <source>compressed</source>
      <translation>已压缩</translation>
    </message>
    <message>
      <source>decoding 16 bits</source>
      <translation>正在按 16 位解码</translation>
    </message>
    <message>
      <source>decoding other steps</source>
      <translation>正在按其他步数解码</translation>
    </message>
    <message>
      <source>decoding while images arrive</source>
      <translation>正在边接收图像边解码</translation>
    </message>
    <message>
      <source>differs from one pose of the robot to the next</source>
      <translation>随机器人的位姿而变化</translation>
    </message>
    <message>
      <source>differs from view to view, whatever the axes read</source>
      <translation>随视图而变化，与各轴读数无关</translation>
    </message>
    <message>
      <source>distances from a nominal</source>
      <translation>到名义模型的距离</translation>
    </message>
    <message>
      <source>dropped</source>
      <translation>已丢弃</translation>
    </message>
    <message>
      <source>error motions of the table, or a part that moved</source>
      <translation>转台的误差运动，或工件移动过</translation>
    </message>
    <message>
      <source>follows the angle of the table</source>
      <translation>随转台角度变化</translation>
    </message>
    <message>
      <source>follows the position of the guide</source>
      <translation>随导轨位置变化</translation>
    </message>
    <message>
      <source>for {v1} mm²: {v2}</source>
      <translation>对 {v1} mm²：{v2}</translation>
    </message>
    <message>
      <source>from the fringe images: full well {full_well} e, read noise less than their grey levels show</source>
      <translation>由条纹图像得出：满阱容量 {full_well} e，读出噪声小于其灰度级所能显示的值</translation>
    </message>
    <message>
      <source>from the fringe images: full well {full_well} e, read noise {read_noise} e</source>
      <translation>由条纹图像得出：满阱容量 {full_well} e，读出噪声 {read_noise} e</translation>
    </message>
    <message>
      <source>holes explained</source>
      <translation>空洞已说明</translation>
    </message>
    <message>
      <source>holes of {v1}</source>
      <translation>{v1} 的空洞</translation>
    </message>
    <message>
      <source>its axes contradict the images</source>
      <translation>其轴与图像矛盾</translation>
    </message>
    <message>
      <source>light scattered below the surface, gloss, or a camera that responds nonlinearly</source>
      <translation>表面下散射的光、光泽，或响应非线性的相机</translation>
    </message>
    <message>
      <source>loop closure</source>
      <translation>闭环</translation>
    </message>
    <message>
      <source>measured by {v1}</source>
      <translation>由 {v1} 测量</translation>
    </message>
    <message>
      <source>measured samples</source>
      <translation>测得的样本</translation>
    </message>
    <message>
      <source>measured: full well {full_well} e, read noise {read_noise} e</source>
      <translation>实测：满阱容量 {full_well} e，读出噪声 {read_noise} e</translation>
    </message>
    <message>
      <source>name or alignment</source>
      <translation>名称或对齐</translation>
    </message>
    <message>
      <source>no phase</source>
      <translation>没有相位</translation>
    </message>
    <message>
      <source>no view has points</source>
      <translation>没有视图含有点</translation>
    </message>
    <message>
      <source>noise measured</source>
      <translation>噪声已测量</translation>
    </message>
    <message>
      <source>other exposures, {v1}</source>
      <translation>其他曝光，{v1}</translation>
    </message>
    <message>
      <source>pictures of reports</source>
      <translation>报告的图片</translation>
    </message>
    <message>
      <source>reading clouds</source>
      <translation>正在读取点云</translation>
    </message>
    <message>
      <source>reading the nominal</source>
      <translation>正在读取名义模型</translation>
    </message>
    <message>
      <source>reconstructing the surface</source>
      <translation>正在重建表面</translation>
    </message>
    <message>
      <source>reconstructing three cameras</source>
      <translation>正在用三台相机重建</translation>
    </message>
    <message>
      <source>reconstructing two</source>
      <translation>正在用两台相机重建</translation>
    </message>
    <message>
      <source>refused by hand: not used</source>
      <translation>手动拒绝：未使用</translation>
    </message>
    <message>
      <source>samples of the nominal</source>
      <translation>名义模型的采样</translation>
    </message>
    <message>
      <source>surface direction</source>
      <translation>表面方向</translation>
    </message>
    <message>
      <source>table angle</source>
      <translation>转台角度</translation>
    </message>
    <message>
      <source>the board of the virtual rig</source>
      <translation>虚拟测量系统的标定板</translation>
    </message>
    <message>
      <source>the board's class is not stated, assumed is {v1}</source>
      <translation>未给出标定板的等级，假定为{v1}</translation>
    </message>
    <message>
      <source>the calibrated robot</source>
      <translation>标定的机器人</translation>
    </message>
    <message>
      <source>the file</source>
      <translation>该文件</translation>
    </message>
    <message>
      <source>the guide</source>
      <translation>导轨</translation>
    </message>
    <message>
      <source>the lens model of the cameras, or a camera that moved since the calibration</source>
      <translation>相机的镜头模型，或标定后移动过的相机</translation>
    </message>
    <message>
      <source>the model of the guide's error motions</source>
      <translation>导轨误差运动的模型</translation>
    </message>
    <message>
      <source>the model of the table's error motions</source>
      <translation>转台误差运动的模型</translation>
    </message>
    <message>
      <source>the repeatability of the axes</source>
      <translation>各轴的重复精度</translation>
    </message>
    <message>
      <source>the rig description</source>
      <translation>测量系统描述</translation>
    </message>
    <message>
      <source>the table's axis</source>
      <translation>转台轴线</translation>
    </message>
    <message>
      <source>{v1} ({v2}) is not ready: {v3}</source>
      <translation>{v1} ({v2}) 未就绪：{v3}</translation>
    </message>
    <message>
      <source>{v1} By its best fit it is displaced by {v2} mm and turned by {v3}°. {v4}.</source>
      <translation>{v1} 按最佳拟合，它平移了 {v2} mm、转动了 {v3}°。{v4}。</translation>
    </message>
    <message>
      <source>{v1} They would agree if {v2}.</source>
      <translation>{v1} 若{v2}，两者即相符。</translation>
    </message>
    <message>
      <source>{v1} and {v2} are of different parts: {v3} and {v4}.</source>
      <translation>{v1} 和 {v2} 属于不同工件：{v3} 和 {v4}。</translation>
    </message>
    <message>
      <source>{v1} are of different parts: {v2} and {v3}.</source>
      <translation>{v1} 属于不同工件：{v2} 和 {v3}。</translation>
    </message>
    <message>
      <source>{v1} cannot be written: {v2} × {v3} px is too large for PNG.</source>
      <translation>无法写入 {v1}：{v2} × {v3} px 对 PNG 太大。</translation>
    </message>
    <message>
      <source>{v1} contains another project ({v2}).</source>
      <translation>{v1} 含有另一项目 ({v2})。</translation>
    </message>
    <message>
      <source>{v1} contains images already.</source>
      <translation>{v1} 已含图像。</translation>
    </message>
    <message>
      <source>{v1} contains no images of the part.</source>
      <translation>{v1} 没有工件图像。</translation>
    </message>
    <message>
      <source>{v1} contains no images of view {v2}.</source>
      <translation>{v1} 没有视图 {v2} 的图像。</translation>
    </message>
    <message>
      <source>{v1} contains no images of viewpoint {v2}.</source>
      <translation>{v1} 没有视点 {v2} 的图像。</translation>
    </message>
    <message>
      <source>{v1} contains no measurement.</source>
      <translation>{v1} 没有测量。</translation>
    </message>
    <message>
      <source>{v1} from {v2}. {v3}</source>
      <translation>{v1} 来自 {v2}。{v3}</translation>
    </message>
    <message>
      <source>{v1} has neither a calibration nor images of the board.</source>
      <translation>{v1} 既没有标定，也没有标定板图像。</translation>
    </message>
    <message>
      <source>{v1} has neither board views nor known cameras.</source>
      <translation>{v1} 既没有标定板视图，也没有已知相机。</translation>
    </message>
    <message>
      <source>{v1} has no axis read-back.</source>
      <translation>{v1} 没有轴的读回。</translation>
    </message>
    <message>
      <source>{v1} has no calibration, which is needed for points.</source>
      <translation>{v1} 没有计算点所需的标定。</translation>
    </message>
    <message>
      <source>{v1} has no clouds yet.</source>
      <translation>{v1} 尚无点云。</translation>
    </message>
    <message>
      <source>{v1} has no nominal.</source>
      <translation>{v1} 没有名义模型。</translation>
    </message>
    <message>
      <source>{v1} has no results.</source>
      <translation>{v1} 没有结果。</translation>
    </message>
    <message>
      <source>{v1} has no scan plan.</source>
      <translation>{v1} 没有扫描计划。</translation>
    </message>
    <message>
      <source>{v1} have different inspection programs ({v2}).</source>
      <translation>{v1} 的检测程序不同 ({v2})。</translation>
    </message>
    <message>
      <source>{v1} is a project of {v2}, which is described differently than {v3} is now.</source>
      <translation>{v1} 是 {v2} 的项目，其描述与 {v3} 现在的不同。</translation>
    </message>
    <message>
      <source>{v1} is damaged: it is not the file that was joined.</source>
      <translation>{v1} 已损坏：它不是合并时的文件。</translation>
    </message>
    <message>
      <source>{v1} is itself joined from several set-ups.</source>
      <translation>{v1} 本身由多次装夹合并而成。</translation>
    </message>
    <message>
      <source>{v1} is joined from several set-ups.</source>
      <translation>{v1} 由多次装夹合并而成。</translation>
    </message>
    <message>
      <source>{v1} is named twice.</source>
      <translation>{v1} 被列出两次。</translation>
    </message>
    <message>
      <source>{v1} proposals</source>
      <translation>{v1} 项建议</translation>
    </message>
    <message>
      <source>{v1} states known = {v2}.</source>
      <translation>{v1} 中写有 known = {v2}。</translation>
    </message>
    <message>
      <source>{v1} things prevent the scan: {v2}</source>
      <translation>有 {v1} 处问题阻碍扫描：{v2}</translation>
    </message>
    <message>
      <source>{v1} views by {v2} cameras, up to {v3} megapixels, about {v4} million points</source>
      <translation>{v2} 台相机的 {v1} 个视图，最高 {v3} 百万像素，约 {v4} 百万个点</translation>
    </message>
    <message>
      <source>{v1} was made with another board ({v2}).</source>
      <translation>{v1} 是用另一标定板 ({v2}) 进行的。</translation>
    </message>
    <message>
      <source>{v1} was measured without an inspection program.</source>
      <translation>{v1} 是在没有检测程序的情况下测量的。</translation>
    </message>
    <message>
      <source>{v1} was not imported from a recording.</source>
      <translation>{v1} 不是从录制导入的。</translation>
    </message>
    <message>
      <source>{v1} were compared with different nominals.</source>
      <translation>{v1} 是与不同名义模型比较的。</translation>
    </message>
    <message>
      <source>{v1}: its points lie {v2} mm in front of what other views see there</source>
      <translation>{v1}：其点位于其他视图在该处所见表面之前 {v2} mm</translation>
    </message>
  </context>
  <context>
    <name>core.planning</name>
    <message>
      <source> And {v1} more.</source>
      <translation> 还有 {v1} 条。</translation>
    </message>
    <message>
      <source>; and {v1} more</source>
      <translation>；还有 {v1} 条</translation>
    </message>
    <message>
      <source>A name begins with a letter or digit, and has letters, digits, '.', '_' and '-' only.</source>
      <translation>名称以字母或数字开头，且只含字母、数字、“.”、“_”和“-”。</translation>
    </message>
    <message>
      <source>A plan needs at least one viewpoint.</source>
      <translation>计划至少需要一个视点。</translation>
    </message>
    <message>
      <source>A stand-off of {v1} mm is impossible.</source>
      <translation>工作距离 {v1} mm 不可能。</translation>
    </message>
    <message>
      <source>Add another one before you remove the last.</source>
      <translation>移除最后一个之前请先添加另一个。</translation>
    </message>
    <message>
      <source>An elevation of {v1}° is impossible.</source>
      <translation>仰角 {v1}° 不可能。</translation>
    </message>
    <message>
      <source>An order names every viewpoint once; {v1}.</source>
      <translation>顺序须每个视点列一次；{v1}。</translation>
    </message>
    <message>
      <source>At this step {v1}.</source>
      <translation>在此步 {v1}。</translation>
    </message>
    <message>
      <source>Change these viewpoints or their order; nothing was moved.</source>
      <translation>请更改这些视点或其顺序；未作任何移动。</translation>
    </message>
    <message>
      <source>Change these viewpoints; nothing was moved.</source>
      <translation>请更改这些视点；未作任何移动。</translation>
    </message>
    <message>
      <source>Change this viewpoint or the order of the plan, or state a park pose that the robot reaches from both; nothing was moved.</source>
      <translation>请更改此视点或计划的顺序，或给出机器人从两处都能到达的停放位姿；什么也没有移动。</translation>
    </message>
    <message>
      <source>Change this viewpoint; nothing was moved.</source>
      <translation>请更改此视点；什么也没有移动。</translation>
    </message>
    <message>
      <source>Check the pose of the part on the table and the rig's limits.</source>
      <translation>请检查工件在转台上的位姿和测量系统的限位。</translation>
    </message>
    <message>
      <source>Choose a distance above 0.</source>
      <translation>请选择大于 0 的距离。</translation>
    </message>
    <message>
      <source>Choose another name.</source>
      <translation>请选择另一名称。</translation>
    </message>
    <message>
      <source>Choose another place, or turn the part over for a second set-up.</source>
      <translation>请选择其他位置，或翻转工件进行第二次装夹。</translation>
    </message>
    <message>
      <source>Choose one of them to change its pose or table angle.</source>
      <translation>请选择其中之一以更改其位姿或转台角度。</translation>
    </message>
    <message>
      <source>Choose one of {v1}.</source>
      <translation>请选择 {v1} 之一。</translation>
    </message>
    <message>
      <source>Choose {v1}…{v2}°.</source>
      <translation>请选择 {v1}…{v2}°。</translation>
    </message>
    <message>
      <source>Correct its pose on the table.</source>
      <translation>请更正其在转台上的位姿。</translation>
    </message>
    <message>
      <source>Correct the order.</source>
      <translation>请更正顺序。</translation>
    </message>
    <message>
      <source>Correct them: links in the robot's file, other bodies in [cell], keep-out boxes in [motion] of the rig description.</source>
      <translation>请更正：连杆在机器人文件中，其他物体在 [cell] 中，禁入区在测量系统描述的 [motion] 中。</translation>
    </message>
    <message>
      <source>Export it again.</source>
      <translation>请重新导出。</translation>
    </message>
    <message>
      <source>Group {v1} has several viewpoints.</source>
      <translation>组 {v1} 有多个视点。</translation>
    </message>
    <message>
      <source>Group {v1} repeats {v2} poses at {v3} table angles; single ones of its viewpoints cannot be removed.</source>
      <translation>组 {v1} 在 {v3} 个转台角度重复 {v2} 个位姿；不能移除其单个视点。</translation>
    </message>
    <message>
      <source>Move another way; nothing was moved.</source>
      <translation>请改用其他方式移动；未作任何移动。</translation>
    </message>
    <message>
      <source>Move it to the centre of the table; if it may overhang, state largest_part_mm in [cell] of the rig description.</source>
      <translation>请将其移到转台中心；若可悬出，请在测量系统描述的 [cell] 中给出 largest_part_mm。</translation>
    </message>
    <message>
      <source>Name the model of this arm in the rig description (model_file), and check tool0 in the controller; nothing was moved.</source>
      <translation>请在测量系统描述中给出此机械臂的型号 (model_file)，并检查控制器中的 tool0；什么也没有移动。</translation>
    </message>
    <message>
      <source>Nothing was changed.</source>
      <translation>未作任何更改。</translation>
    </message>
    <message>
      <source>Only groups can be ungrouped.</source>
      <translation>只有组可以取消分组。</translation>
    </message>
    <message>
      <source>Only single viewpoints can be made a group.</source>
      <translation>只有单个视点可以成组。</translation>
    </message>
    <message>
      <source>Rename the group, or ungroup it first.</source>
      <translation>请先重命名组，或取消分组。</translation>
    </message>
    <message>
      <source>Request 1 to {v1}.</source>
      <translation>请要求 1 到 {v1} 个。</translation>
    </message>
    <message>
      <source>See `measureapp plan show` for its names.</source>
      <translation>名称请见 `measureapp plan show`。</translation>
    </message>
    <message>
      <source>Select single viewpoints, or ungroup first.</source>
      <translation>请选择单个视点，或先取消分组。</translation>
    </message>
    <message>
      <source>State its unit if it is not in millimetres.</source>
      <translation>若不是毫米，请说明其单位。</translation>
    </message>
    <message>
      <source>State the unit of the nominal if it is not in millimetres, or lay the part down.</source>
      <translation>若不是毫米，请说明名义模型的单位，或将工件放平。</translation>
    </message>
    <message>
      <source>State the unit of the nominal if it is not in millimetres, or move the part to the middle of the table.</source>
      <translation>若不是毫米，请说明名义模型的单位，或将工件移到转台中间。</translation>
    </message>
    <message>
      <source>The bodies {v1} touch whatever the joint angles: the model of the cell is wrong.</source>
      <translation>无论关节角如何，物体 {v1} 都接触：工作站模型有误。</translation>
    </message>
    <message>
      <source>The kinematic model does not have the pose read back, so collisions cannot be checked. {v1}</source>
      <translation>运动学模型与读回的位姿不符，因此无法检查碰撞。{v1}</translation>
    </message>
    <message>
      <source>The kinematic model states no bodies of the links: thick capsules along them were checked for collisions instead.</source>
      <translation>运动学模型未给出连杆实体：改用沿连杆的粗胶囊体检查碰撞。</translation>
    </message>
    <message>
      <source>The move from place {v1} to {v2} is not free: {v3}</source>
      <translation>从位置 {v1} 到 {v2} 的移动不畅通：{v3}</translation>
    </message>
    <message>
      <source>The name {v1} is taken.</source>
      <translation>名称 {v1} 已被使用。</translation>
    </message>
    <message>
      <source>The nominal has no surface: all its triangles are degenerate.</source>
      <translation>名义模型没有表面：其所有三角形均退化。</translation>
    </message>
    <message>
      <source>The nominal has no triangles, or corners that are not finite.</source>
      <translation>名义模型没有三角形，或顶点不是有限值。</translation>
    </message>
    <message>
      <source>The nominal is {v1} mm long, too small to be measured.</source>
      <translation>名义模型长 {v1} mm，太小而无法测量。</translation>
    </message>
    <message>
      <source>The part is not known: it was not checked for collisions.</source>
      <translation>工件未知：未检查其碰撞。</translation>
    </message>
    <message>
      <source>The part is too large for {v1}: turning with the table it needs {v2} mm, and parts may have up to {v3} mm.</source>
      <translation>工件对 {v1} 太大：随转台转动需要 {v2} mm，而工件最多 {v3} mm。</translation>
    </message>
    <message>
      <source>The part is too large for {v1}: turning with the table it needs {v2} mm; {v3} mm are allowed.</source>
      <translation>工件对 {v1} 太大：随转台转动需要 {v2} mm；允许 {v3} mm。</translation>
    </message>
    <message>
      <source>The part is {v1} mm high; the robot of {v2} reaches {v3} mm above the table.</source>
      <translation>工件高 {v1} mm；{v2} 的机器人在转台上方可达 {v3} mm。</translation>
    </message>
    <message>
      <source>The part reaches {v1} mm below the top of the table.</source>
      <translation>工件低于转台台面 {v1} mm。</translation>
    </message>
    <message>
      <source>The plan exceeds the limits of {v1}: {v2}.</source>
      <translation>计划超出 {v1} 的限位：{v2}。</translation>
    </message>
    <message>
      <source>The plan has no viewpoint or group {v1}.</source>
      <translation>计划没有视点或组 {v1}。</translation>
    </message>
    <message>
      <source>The plan is not free of collisions. {v1}</source>
      <translation>计划有碰撞。{v1}</translation>
    </message>
    <message>
      <source>The pose read back is {v1} mm off the one of {v2} for the same joints: collisions cannot be checked.</source>
      <translation>相同关节角下，读回的位姿与 {v2} 的位姿相差 {v1} mm：无法检查碰撞。</translation>
    </message>
    <message>
      <source>The rig description states no speed of {v1}: the time assumes usual ones.</source>
      <translation>测量系统描述未给出{v1}的速度：时间按常用速度估计。</translation>
    </message>
    <message>
      <source>The rig names no kinematic model of its robot: only the head was checked for collisions, on straight ways, not the robot's arm.</source>
      <translation>测量系统未给出其机器人的运动学模型：只在直线路径上检查了测头的碰撞，未检查机械臂。</translation>
    </message>
    <message>
      <source>The viewpoints form {v1} groups without {v2} of common area: registration cannot connect them.</source>
      <translation>这些视点分成 {v1} 组，公共区域不足 {v2}：配准无法将它们连接起来。</translation>
    </message>
    <message>
      <source>Their product may be {v1} at most.</source>
      <translation>其乘积最多为 {v1}。</translation>
    </message>
    <message>
      <source>There is no free way to {v1}: on the direct one, {v2} {v3}.</source>
      <translation>没有通往 {v1} 的畅通路径：在直接路径上，{v2}，{v3}。</translation>
    </message>
    <message>
      <source>There is no pattern set {v1}.</source>
      <translation>没有图案集 {v1}。</translation>
    </message>
    <message>
      <source>This is impossible: {v1}.</source>
      <translation>这不可能：{v1}。</translation>
    </message>
    <message>
      <source>Ungroup it first, or remove all viewpoints of a pose or of a table angle.</source>
      <translation>请先取消分组，或移除一个位姿或一个转台角度的所有视点。</translation>
    </message>
    <message>
      <source>Write a plan for this part.</source>
      <translation>请为此工件编写计划。</translation>
    </message>
    <message>
      <source>after {v1} % of the {v2}'s move</source>
      <translation>在{v2}移动的 {v1} % 之后</translation>
    </message>
    <message>
      <source>arm of unknown shape</source>
      <translation>形状未知的机械臂</translation>
    </message>
    <message>
      <source>by the park pose</source>
      <translation>经由停放位姿</translation>
    </message>
    <message>
      <source>camera {v1}</source>
      <translation>相机 {v1}</translation>
    </message>
    <message>
      <source>drawn back by {v1} mm</source>
      <translation>退回 {v1} mm</translation>
    </message>
    <message>
      <source>exactly that many, with the best coverage; none: as many as needed</source>
      <translation>恰好这么多，覆盖率最佳；无：按需要的数量</translation>
    </message>
    <message>
      <source>flange {v1} mm from the shoulder is outside {v2}…{v3} mm</source>
      <translation>法兰距肩部 {v1} mm，超出 {v2}…{v3} mm</translation>
    </message>
    <message>
      <source>guide at {v1} mm is outside {v2}…{v3} mm</source>
      <translation>导轨位于 {v1} mm，超出 {v2}…{v3} mm</translation>
    </message>
    <message>
      <source>in the order {v1}</source>
      <translation>按 {v1} 的顺序</translation>
    </message>
    <message>
      <source>keep-out box {v1}</source>
      <translation>禁入区 {v1}</translation>
    </message>
    <message>
      <source>light must rise, and have one positive standard deviation for each value</source>
      <translation>光强必须递增，且每个值有一个正的标准差</translation>
    </message>
    <message>
      <source>linear guide</source>
      <translation>直线导轨</translation>
    </message>
    <message>
      <source>measuring head ({v1})</source>
      <translation>测头（{v1}）</translation>
    </message>
    <message>
      <source>of the surface</source>
      <translation>占表面的比例</translation>
    </message>
    <message>
      <source>of what some feasible viewpoint measures</source>
      <translation>占某个可行视点所能测量部分的比例</translation>
    </message>
    <message>
      <source>reach and collisions</source>
      <translation>可达性与碰撞</translation>
    </message>
    <message>
      <source>required of a point, coverage is then of information 1/σ²; none: it is measured</source>
      <translation>对点的要求，此时覆盖率按信息量 1/σ² 计；无：测得即可</translation>
    </message>
    <message>
      <source>robot's base</source>
      <translation>机器人底座</translation>
    </message>
    <message>
      <source>robot's link {v1}</source>
      <translation>机器人 {v1} 号连杆</translation>
    </message>
    <message>
      <source>rotary table</source>
      <translation>转台</translation>
    </message>
    <message>
      <source>share of its area that a viewpoint has in common with others</source>
      <translation>一个视点与其他视点共有的面积比例</translation>
    </message>
    <message>
      <source>table at {v1}° is outside {v2}…{v3}°</source>
      <translation>转台位于 {v1}°，超出 {v2}…{v3}°</translation>
    </message>
    <message>
      <source>that see each place where candidates allow: overlap joins the clouds</source>
      <translation>在候选视点允许之处看到每个位置的视点数：重叠使点云相连</translation>
    </message>
    <message>
      <source>the plan</source>
      <translation>计划</translation>
    </message>
    <message>
      <source>the {v1} would collide with the {v2}</source>
      <translation>{v1}将与{v2}碰撞</translation>
    </message>
    <message>
      <source>the {v1} would come within {v2} mm of the {v3} (at least {v4} mm)</source>
      <translation>{v1}将接近{v3}至 {v2} mm（至少需 {v4} mm）</translation>
    </message>
    <message>
      <source>the {v1} would enter the {v2}</source>
      <translation>{v1}将进入{v2}</translation>
    </message>
    <message>
      <source>viewpoints for pockets</source>
      <translation>凹腔的视点</translation>
    </message>
    <message>
      <source>view{v1}</source>
      <translation>view{v1}</translation>
    </message>
    <message>
      <source>what cannot be seen</source>
      <translation>看不到的部分</translation>
    </message>
    <message>
      <source>{v1} And {v2} more.</source>
      <translation>{v1} 另有 {v2} 处。</translation>
    </message>
    <message>
      <source>{v1} and {v2}</source>
      <translation>{v1} 和 {v2}</translation>
    </message>
    <message>
      <source>{v1} cannot be a name.</source>
      <translation>{v1} 不能用作名称。</translation>
    </message>
    <message>
      <source>{v1} cannot be approached: {v2}.</source>
      <translation>无法接近 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>{v1} cannot measure any of the part: none of {v2} feasible viewpoints sees it.</source>
      <translation>{v1} 不能测量工件的任何部分：{v2} 个可行视点均看不到。</translation>
    </message>
    <message>
      <source>{v1} cannot reach a viewpoint of this part at or near an elevation of {v2}°.</source>
      <translation>{v1} 在仰角 {v2}° 或附近不能到达此工件的视点。</translation>
    </message>
    <message>
      <source>{v1} is a single viewpoint.</source>
      <translation>{v1} 是单个视点。</translation>
    </message>
    <message>
      <source>{v1} is given twice</source>
      <translation>{v1} 出现两次</translation>
    </message>
    <message>
      <source>{v1} is missing</source>
      <translation>缺少 {v1}</translation>
    </message>
    <message>
      <source>{v1} is named after its group {v2}.</source>
      <translation>{v1} 以其组 {v2} 命名。</translation>
    </message>
    <message>
      <source>{v1} is not in the plan</source>
      <translation>{v1} 不在计划中</translation>
    </message>
    <message>
      <source>{v1} reaches no viewpoint that sees this place of the part at less than {v2}° to its surface normal.</source>
      <translation>{v1} 不能到达与该处表面法线夹角小于 {v2}° 的视点。</translation>
    </message>
    <message>
      <source>{v1} samples and {v2} candidates need too much memory.</source>
      <translation>{v1} 个采样和 {v2} 个候选需要太多内存。</translation>
    </message>
    <message>
      <source>{v1} viewpoints</source>
      <translation>{v1} 个视点</translation>
    </message>
    <message>
      <source>{v1} viewpoints chosen</source>
      <translation>已选择 {v1} 个视点</translation>
    </message>
    <message>
      <source>{v1} viewpoints were requested.</source>
      <translation>要求了 {v1} 个视点。</translation>
    </message>
    <message>
      <source>{v1} viewpoints were requested; no more than {v2} add anything.</source>
      <translation>要求 {v1} 个视点；多于 {v2} 个不再增加任何内容。</translation>
    </message>
    <message>
      <source>{v1} viewpoints, exchanges</source>
      <translation>{v1} 个视点，交换</translation>
    </message>
    <message>
      <source>{v1}: every configuration is near a singularity, such as {v2}</source>
      <translation>{v1}：每种构型都接近奇异，例如 {v2}</translation>
    </message>
    <message>
      <source>{v1}; and {v2} more</source>
      <translation>{v1}；另有 {v2} 处</translation>
    </message>
  </context>
  <context>
    <name>core.project</name>
    <message>
      <source> (and {v1} more)</source>
      <translation>（另有 {v1} 处）</translation>
    </message>
    <message>
      <source>, and {v1} more of the {v2} images</source>
      <translation>，以及 {v2} 幅图像中的另外 {v1} 幅</translation>
    </message>
    <message>
      <source>--alignment {v1}: {v2}.</source>
      <translation>--alignment {v1}：{v2}。</translation>
    </message>
    <message>
      <source>--images names camera {v1} twice.</source>
      <translation>--images 两次列出相机 {v1}。</translation>
    </message>
    <message>
      <source>--images {v1} names no camera.</source>
      <translation>--images {v1} 没有指定相机。</translation>
    </message>
    <message>
      <source>A release needs a name.</source>
      <translation>发布需要名称。</translation>
    </message>
    <message>
      <source>A six-axis arm is needed.</source>
      <translation>需要六轴手臂。</translation>
    </message>
    <message>
      <source>A temperature of the board says nothing without its class or certificate.</source>
      <translation>没有等级或证书，标定板的温度没有意义。</translation>
    </message>
    <message>
      <source>Add a second pitch or a Gray code.</source>
      <translation>请添加第二个间距或格雷码。</translation>
    </message>
    <message>
      <source>Add limits (lower, upper, velocity) to every revolute joint.</source>
      <translation>请为每个旋转关节添加限位（下限、上限、速度）。</translation>
    </message>
    <message>
      <source>Add projector_px (projector_rows for horizontal fringes).</source>
      <translation>请添加 projector_px（水平条纹为 projector_rows）。</translation>
    </message>
    <message>
      <source>Add rows below the header {v1}.</source>
      <translation>请在表头 {v1} 下方添加行。</translation>
    </message>
    <message>
      <source>Add the grey level of a saturated pixel: 1023, 4095 or 65535.</source>
      <translation>请添加饱和像素的灰度：1023、4095 或 65535。</translation>
    </message>
    <message>
      <source>Add the missing images.</source>
      <translation>请添加缺少的图像。</translation>
    </message>
    <message>
      <source>Add the shifted sinusoids.</source>
      <translation>请添加相移正弦条纹。</translation>
    </message>
    <message>
      <source>Add {v1} at the top of the file.</source>
      <translation>请在文件开头添加 {v1}。</translation>
    </message>
    <message>
      <source>Calibrate again, or delete this file to continue without it.</source>
      <translation>请重新标定，或删除此文件以在没有它的情况下继续。</translation>
    </message>
    <message>
      <source>Calibrate the rig into this project first.</source>
      <translation>请先将测量系统标定到此项目。</translation>
    </message>
    <message>
      <source>Check memory and disk of the computer.</source>
      <translation>请检查计算机的内存和磁盘。</translation>
    </message>
    <message>
      <source>Check the disk and its connection, or choose another folder. What was stored before is kept.</source>
      <translation>请检查磁盘及其连接，或选择其他文件夹。之前存储的内容会保留。</translation>
    </message>
    <message>
      <source>Check the disk and its connection.</source>
      <translation>请检查磁盘及其连接。</translation>
    </message>
    <message>
      <source>Check the folder and its permissions.</source>
      <translation>请检查文件夹及其权限。</translation>
    </message>
    <message>
      <source>Check the folder and quote the pattern.</source>
      <translation>请检查文件夹，并给模式加引号。</translation>
    </message>
    <message>
      <source>Check the path in the manifest.</source>
      <translation>请检查清单中的路径。</translation>
    </message>
    <message>
      <source>Check the path.</source>
      <translation>请检查路径。</translation>
    </message>
    <message>
      <source>Check the path. If its disk was removed, connect it again; if it was moved, put it back.</source>
      <translation>请检查路径。若其磁盘已移除，请重新连接；若已被移动，请放回原处。</translation>
    </message>
    <message>
      <source>Check the permissions of the folder.</source>
      <translation>请检查文件夹的权限。</translation>
    </message>
    <message>
      <source>Check the permissions, or choose another folder.</source>
      <translation>请检查权限，或选择另一文件夹。</translation>
    </message>
    <message>
      <source>Check the permissions, or copy the folder to a disk of your own.</source>
      <translation>请检查权限，或将文件夹复制到自己的磁盘。</translation>
    </message>
    <message>
      <source>Check the size given in [board], the unit of the certificate (mm), and that it numbers the marks row by row from 0.</source>
      <translation>请检查 [board] 中的尺寸、证书的单位 (mm)，以及标记从 0 起逐行编号。</translation>
    </message>
    <message>
      <source>Choose a folder outside the project.</source>
      <translation>请选择项目之外的文件夹。</translation>
    </message>
    <message>
      <source>Choose a folder that exists.</source>
      <translation>请选择存在的文件夹。</translation>
    </message>
    <message>
      <source>Choose a folder with a shorter path.</source>
      <translation>请选择路径较短的文件夹。</translation>
    </message>
    <message>
      <source>Choose a new or an empty folder for the copy.</source>
      <translation>请为副本选择新的或空的文件夹。</translation>
    </message>
    <message>
      <source>Choose a new or an empty folder.</source>
      <translation>请选择新的或空的文件夹。</translation>
    </message>
    <message>
      <source>Choose another path.</source>
      <translation>请选择其他路径。</translation>
    </message>
    <message>
      <source>Choose one of its features or dimensions.</source>
      <translation>请选择其特征或尺寸之一。</translation>
    </message>
    <message>
      <source>Choose one with {v1} or more digits or letters.</source>
      <translation>请选择至少 {v1} 个数字或字母的。</translation>
    </message>
    <message>
      <source>Choose the certificate of this board, or correct the board.</source>
      <translation>请选择此标定板的证书，或更正标定板。</translation>
    </message>
    <message>
      <source>Choose the folder that holds the fringe images of the board.</source>
      <translation>请选择含标定板条纹图像的文件夹。</translation>
    </message>
    <message>
      <source>Choose the folder that holds the images of the board.</source>
      <translation>请选择含标定板图像的文件夹。</translation>
    </message>
    <message>
      <source>Compute it again: measureapp process PROJECT.</source>
      <translation>请重新计算：measureapp process PROJECT。</translation>
    </message>
    <message>
      <source>Convert the positions from metres to mm.</source>
      <translation>请将位置从米换算为 mm。</translation>
    </message>
    <message>
      <source>Copy or record it again.</source>
      <translation>请重新复制或录制。</translation>
    </message>
    <message>
      <source>Copy the file again from where it was written.</source>
      <translation>请从写出处重新复制文件。</translation>
    </message>
    <message>
      <source>Copy the mesh there, or correct `nominal`.</source>
      <translation>请将网格复制到那里，或更正 `nominal`。</translation>
    </message>
    <message>
      <source>Copying {v1}</source>
      <translation>正在复制 {v1}</translation>
    </message>
    <message>
      <source>Correct it, or delete it and set operator mode up again.</source>
      <translation>请更正它，或删除它并重新设置操作模式。</translation>
    </message>
    <message>
      <source>Correct periods or {v1}.</source>
      <translation>请更正 periods 或 {v1}。</translation>
    </message>
    <message>
      <source>Correct the axis of this joint.</source>
      <translation>请更正此关节的轴。</translation>
    </message>
    <message>
      <source>Correct the paths, which are relative to the manifest's folder, or copy the images there.</source>
      <translation>请更正路径（相对于清单的文件夹），或将图像复制到那里。</translation>
    </message>
    <message>
      <source>Correct the value.</source>
      <translation>请更正该值。</translation>
    </message>
    <message>
      <source>Correct this attribute.</source>
      <translation>请更正此属性。</translation>
    </message>
    <message>
      <source>Correct this entry of the inspection program.</source>
      <translation>请更正检测程序的此条目。</translation>
    </message>
    <message>
      <source>Correct this entry of the plan.</source>
      <translation>请更正计划的此条目。</translation>
    </message>
    <message>
      <source>Correct this line.</source>
      <translation>请更正此行。</translation>
    </message>
    <message>
      <source>Delete the DOCTYPE from the file.</source>
      <translation>请从文件中删除 DOCTYPE。</translation>
    </message>
    <message>
      <source>End its name in .toml or .json.</source>
      <translation>其名称请以 .toml 或 .json 结尾。</translation>
    </message>
    <message>
      <source>Export or copy the file again.</source>
      <translation>请重新导出或复制文件。</translation>
    </message>
    <message>
      <source>Export the URDF of the arm again; a xacro file has to be expanded first.</source>
      <translation>请重新导出机械臂的 URDF；xacro 文件须先展开。</translation>
    </message>
    <message>
      <source>Export the arm alone, without gripper, guide or second arm.</source>
      <translation>请只导出手臂，不含夹爪、导轨或第二手臂。</translation>
    </message>
    <message>
      <source>Export the part again as OBJ with a mesh in it.</source>
      <translation>请将工件重新导出为含网格的 OBJ。</translation>
    </message>
    <message>
      <source>Export the part as STL from the CAD program.</source>
      <translation>请从 CAD 程序将工件导出为 STL。</translation>
    </message>
    <message>
      <source>Filter it again on the page Clouds.</source>
      <translation>请在“点云”页重新过滤。</translation>
    </message>
    <message>
      <source>Free some space, choose another disk, or scan at a lower resolution.</source>
      <translation>请释放一些空间，选择其他磁盘，或以较低分辨率扫描。</translation>
    </message>
    <message>
      <source>Free some space, or choose another disk.</source>
      <translation>请释放一些空间，或选择另一磁盘。</translation>
    </message>
    <message>
      <source>Free some space, or choose another folder.</source>
      <translation>请释放一些空间，或选择其他文件夹。</translation>
    </message>
    <message>
      <source>Free some space, or choose another folder. What was stored before is kept.</source>
      <translation>请释放一些空间，或选择其他文件夹。之前存储的内容会保留。</translation>
    </message>
    <message>
      <source>Free some space. What was stored before is kept.</source>
      <translation>请释放一些空间。之前存储的内容会保留。</translation>
    </message>
    <message>
      <source>Give --unit {v1}, or correct the names of the columns.</source>
      <translation>请给出 --unit {v1}，或更正列名。</translation>
    </message>
    <message>
      <source>Give --unit {v1}.</source>
      <translation>请给出 --unit {v1}。</translation>
    </message>
    <message>
      <source>Give 4, 5, 8, 12 or 14 coefficients in OpenCV's order.</source>
      <translation>请按 OpenCV 的顺序给出 4、5、8、12 或 14 个系数。</translation>
    </message>
    <message>
      <source>Give [[fx, 0, cx], [0, fy, cy], [0, 0, 1]] in pixels.</source>
      <translation>请以像素给出 [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]。</translation>
    </message>
    <message>
      <source>Give a PLY, STL, OBJ or STEP file.</source>
      <translation>请给出 PLY、STL、OBJ 或 STEP 文件。</translation>
    </message>
    <message>
      <source>Give a cameras.json written by `measureapp calibrate cameras`.</source>
      <translation>请给出由 `measureapp calibrate cameras` 写出的 cameras.json。</translation>
    </message>
    <message>
      <source>Give a file with one point (x y z) a line.</source>
      <translation>请给出每行一个点 (x y z) 的文件。</translation>
    </message>
    <message>
      <source>Give a folder with a {v1}, a logo and texts.</source>
      <translation>请指定一个含有 {v1}、徽标和文本的文件夹。</translation>
    </message>
    <message>
      <source>Give a mesh, or make one of the cloud first.</source>
      <translation>请给出网格，或先由点云生成。</translation>
    </message>
    <message>
      <source>Give a part program that `measureapp program pack` has written.</source>
      <translation>请指定由 `measureapp program pack` 写出的工件程序。</translation>
    </message>
    <message>
      <source>Give a rig description (TOML), or one of: {v1}.</source>
      <translation>请给出测量系统描述 (TOML)，或其一：{v1}。</translation>
    </message>
    <message>
      <source>Give a scan plan as JSON or TOML.</source>
      <translation>请以 JSON 或 TOML 给出扫描计划。</translation>
    </message>
    <message>
      <source>Give a unit quaternion, scalar first; not angles in degrees.</source>
      <translation>请给出单位四元数，标量在前；不是以度为单位的角。</translation>
    </message>
    <message>
      <source>Give an inspection program in TOML.</source>
      <translation>请以 TOML 给出检测程序。</translation>
    </message>
    <message>
      <source>Give at most {v1}.</source>
      <translation>请最多给出 {v1}。</translation>
    </message>
    <message>
      <source>Give comma-separated values in UTF-8.</source>
      <translation>请给出 UTF-8 的逗号分隔值。</translation>
    </message>
    <message>
      <source>Give each exposure once.</source>
      <translation>请每个曝光给出一次。</translation>
    </message>
    <message>
      <source>Give every camera the same images.</source>
      <translation>请给每台相机相同的图像。</translation>
    </message>
    <message>
      <source>Give it as 2026-05-04 or 2026-05-04T10:20:30+02:00.</source>
      <translation>请写作 2026-05-04 或 2026-05-04T10:20:30+02:00。</translation>
    </message>
    <message>
      <source>Give it in °C with its uncertainty (k = 2), such as 21.5±0.5.</source>
      <translation>请以 °C 给出，并附其不确定度 (k = 2)，如 21.5±0.5。</translation>
    </message>
    <message>
      <source>Give labels such as "left.fx" or "right.x_mm".</source>
      <translation>请给出 "left.fx" 或 "right.x_mm" 之类的标签。</translation>
    </message>
    <message>
      <source>Give names with numbers.</source>
      <translation>请给出带编号的名称。</translation>
    </message>
    <message>
      <source>Give one image of every camera per board position.</source>
      <translation>请每个标定板位置给出每台相机的一幅图像。</translation>
    </message>
    <message>
      <source>Give one of: {v1}.</source>
      <translation>请给出以下之一：{v1}。</translation>
    </message>
    <message>
      <source>Give one pattern per camera.</source>
      <translation>请每台相机给出一个模式。</translation>
    </message>
    <message>
      <source>Give one value, at the top of the file.</source>
      <translation>请在文件开头给出一个值。</translation>
    </message>
    <message>
      <source>Give the angles of all positions, or none.</source>
      <translation>请给出所有位置的角度，或都不给。</translation>
    </message>
    <message>
      <source>Give the arguments of the command as strings.</source>
      <translation>请以字符串给出命令的参数。</translation>
    </message>
    <message>
      <source>Give the file of an arm (TOML or URDF), or one of: {v1}.</source>
      <translation>请给出手臂的文件（TOML 或 URDF），或其一：{v1}。</translation>
    </message>
    <message>
      <source>Give the image's size in pixels.</source>
      <translation>请以像素给出图像尺寸。</translation>
    </message>
    <message>
      <source>Give the images of one camera.</source>
      <translation>请给出一台相机的图像。</translation>
    </message>
    <message>
      <source>Give the path of a MANIFEST.toml.</source>
      <translation>请给出 MANIFEST.toml 的路径。</translation>
    </message>
    <message>
      <source>Give the path of a RECORDING.toml.</source>
      <translation>请给出 RECORDING.toml 的路径。</translation>
    </message>
    <message>
      <source>Give the path of a cameras.json: `measureapp calibrate cameras --out` writes it, `measureapp process` that of a project.</source>
      <translation>请给出 cameras.json 的路径：由 `measureapp calibrate cameras --out` 写出，项目中的则由 `measureapp process` 写出。</translation>
    </message>
    <message>
      <source>Give the path of the file to be written.</source>
      <translation>请给出要写入的文件的路径。</translation>
    </message>
    <message>
      <source>Give the picture of the part as PNG.</source>
      <translation>请以 PNG 给出工件图片。</translation>
    </message>
    <message>
      <source>Give the projector another name.</source>
      <translation>请给投影仪起另一个名称。</translation>
    </message>
    <message>
      <source>Give x, y and z on every line.</source>
      <translation>请在每行给出 x、y 和 z。</translation>
    </message>
    <message>
      <source>Give {v1}, at the top of the file.</source>
      <translation>请在文件开头给出 {v1}。</translation>
    </message>
    <message>
      <source>Give {v1}.</source>
      <translation>请给出 {v1}。</translation>
    </message>
    <message>
      <source>Give {{"left": {{…}}, …}}.</source>
      <translation>请给出 {{"left": {{…}}, …}}。</translation>
    </message>
    <message>
      <source>If the PIN is forgotten, run `measureapp gui --reset-engineer-pin` on this computer, then set a new one.</source>
      <translation>如果忘记了 PIN，请在这台计算机上运行 `measureapp gui --reset-engineer-pin`，然后设置新的 PIN。</translation>
    </message>
    <message>
      <source>Image {v1} cannot be decoded.</source>
      <translation>无法解码图像 {v1}。</translation>
    </message>
    <message>
      <source>Image {v1} cannot be read: {v2}.</source>
      <translation>无法读取图像 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>Image {v1} differs from {v2} in size or bit depth.</source>
      <translation>图像 {v1} 的尺寸或位深与 {v2} 不同。</translation>
    </message>
    <message>
      <source>Image {v1} has {v2} bit, {v3} has {v4} bit.</source>
      <translation>图像 {v1} 为 {v2} 位，{v3} 为 {v4} 位。</translation>
    </message>
    <message>
      <source>Image {v1} has {v2} pixels.</source>
      <translation>图像 {v1} 有 {v2} 像素。</translation>
    </message>
    <message>
      <source>Image {v1} has {v2} × {v3} px, {v4} has {v5} × {v6} px.</source>
      <translation>图像 {v1} 为 {v2} × {v3} px，{v4} 为 {v5} × {v6} px。</translation>
    </message>
    <message>
      <source>Image {v1} is truncated: its end is missing.</source>
      <translation>图像 {v1} 被截断：缺少末尾。</translation>
    </message>
    <message>
      <source>Install it with `python -m pip install {v1}` in MeasureApp's environment, or export the part as STL.</source>
      <translation>请在 MeasureApp 的环境中用 `python -m pip install {v1}` 安装，或将工件导出为 STL。</translation>
    </message>
    <message>
      <source>Its 3×3 part must be a rotation; lengths in mm.</source>
      <translation>其 3×3 部分须为旋转；长度单位 mm。</translation>
    </message>
    <message>
      <source>Its last row is 0 0 0 1; lengths in mm.</source>
      <translation>其最后一行为 0 0 0 1；长度单位 mm。</translation>
    </message>
    <message>
      <source>Known fields: {v1}.</source>
      <translation>已知字段：{v1}。</translation>
    </message>
    <message>
      <source>Leave the unit of the nominal out.</source>
      <translation>请省略名义模型的单位。</translation>
    </message>
    <message>
      <source>Leave the unit out.</source>
      <translation>请省略单位。</translation>
    </message>
    <message>
      <source>Link {v1} is not between {v2} and {v3}.</source>
      <translation>连杆 {v1} 不在 {v2} 与 {v3} 之间。</translation>
    </message>
    <message>
      <source>Link {v1} is the child of several joints.</source>
      <translation>连杆 {v1} 是多个关节的子连杆。</translation>
    </message>
    <message>
      <source>Measure the noise again with `measureapp noise`.</source>
      <translation>请用 `measureapp noise` 重新测量噪声。</translation>
    </message>
    <message>
      <source>Measure the part with an inspection program first.</source>
      <translation>请先用检测程序测量工件。</translation>
    </message>
    <message>
      <source>Measured results are kept; measure the part again and state why.</source>
      <translation>测量结果会保留；请重新测量工件并说明原因。</translation>
    </message>
    <message>
      <source>Name a file of the project, such as inspection/program.toml.</source>
      <translation>请指定项目的文件，如 inspection/program.toml。</translation>
    </message>
    <message>
      <source>Name a folder that contains a {v1}.</source>
      <translation>请指定含有 {v1} 的文件夹。</translation>
    </message>
    <message>
      <source>Name a link of the chain as base.</source>
      <translation>请指定链中的一个连杆为基座。</translation>
    </message>
    <message>
      <source>Name a rig description (TOML).</source>
      <translation>请指定测量系统描述 (TOML)。</translation>
    </message>
    <message>
      <source>Name each parameter once.</source>
      <translation>请每个参数列一次。</translation>
    </message>
    <message>
      <source>Name every camera in every group.</source>
      <translation>请在每组中列出每台相机。</translation>
    </message>
    <message>
      <source>Name its cameras: {v1}.</source>
      <translation>请列出其相机：{v1}。</translation>
    </message>
    <message>
      <source>Name project folders, or folders with projects in them.</source>
      <translation>请指定项目文件夹，或含项目的文件夹。</translation>
    </message>
    <message>
      <source>Name the columns x, y, z with mm, inch, m, cm or um.</source>
      <translation>请将列命名为 x、y、z，并注明 mm、inch、m、cm 或 um。</translation>
    </message>
    <message>
      <source>Name the file of an arm (TOML or URDF).</source>
      <translation>请指定机械臂的文件（TOML 或 URDF）。</translation>
    </message>
    <message>
      <source>Name the images by camera and number, such as left01.png and right01.png, or use one folder per camera.</source>
      <translation>请按相机和编号命名图像，例如 left01.png 和 right01.png，或每台相机用一个文件夹。</translation>
    </message>
    <message>
      <source>Name the link of the flange, one of: {v1}.</source>
      <translation>请指定法兰的连杆，其一：{v1}。</translation>
    </message>
    <message>
      <source>Name {v1} images, in order.</source>
      <translation>请按顺序列出 {v1} 幅图像。</translation>
    </message>
    <message>
      <source>No file matches {v1}.</source>
      <translation>没有文件与 {v1} 匹配。</translation>
    </message>
    <message>
      <source>No image matches {v1} for camera {v2}.</source>
      <translation>没有图像与相机 {v2} 的 {v1} 匹配。</translation>
    </message>
    <message>
      <source>No images were given.</source>
      <translation>没有给出图像。</translation>
    </message>
    <message>
      <source>No joint ends at a link {v1}.</source>
      <translation>没有关节止于连杆 {v1}。</translation>
    </message>
    <message>
      <source>No manifest matches {v1}.</source>
      <translation>没有清单与 {v1} 匹配。</translation>
    </message>
    <message>
      <source>Number the corners the same way at all positions.</source>
      <translation>请在所有位置以相同方式给角点编号。</translation>
    </message>
    <message>
      <source>Number the marks from 0 row by row, all with the same position.</source>
      <translation>请从 0 起逐行给标记编号，所有位置相同。</translation>
    </message>
    <message>
      <source>Only open chains are supported.</source>
      <translation>只支持开链。</translation>
    </message>
    <message>
      <source>Only revolute joints with limits, and fixed ones, are supported.</source>
      <translation>只支持有限位的旋转关节和固定关节。</translation>
    </message>
    <message>
      <source>Open it with that version.</source>
      <translation>请用该版本打开。</translation>
    </message>
    <message>
      <source>Open it with the version that wrote it, or a later one.</source>
      <translation>请用写出它的版本或更高版本打开。</translation>
    </message>
    <message>
      <source>Open the project with that version.</source>
      <translation>请用该版本打开项目。</translation>
    </message>
    <message>
      <source>Point the cameras at a stationary surface with bright and dark areas, and measure again.</source>
      <translation>请将相机对准有明暗区域的静止表面，并重新测量。</translation>
    </message>
    <message>
      <source>Process it once with this version.</source>
      <translation>请用此版本处理一次。</translation>
    </message>
    <message>
      <source>Put the pattern in quotes and check the folder.</source>
      <translation>请给模式加引号并检查文件夹。</translation>
    </message>
    <message>
      <source>Read it as plain points, or process the project again.</source>
      <translation>请将其作为普通点读取，或重新处理项目。</translation>
    </message>
    <message>
      <source>Read it as plain points, or stitch again.</source>
      <translation>请将其作为普通点读取，或重新拼接。</translation>
    </message>
    <message>
      <source>Rebuild it from the project folders: measureapp series rebuild PROGRAM PROJECT…</source>
      <translation>请由项目文件夹重建：measureapp series rebuild PROGRAM PROJECT…</translation>
    </message>
    <message>
      <source>Recompute them: measureapp process PROJECT.</source>
      <translation>请重新计算：measureapp process PROJECT。</translation>
    </message>
    <message>
      <source>Record all images with one bit depth.</source>
      <translation>请以同一位深录制所有图像。</translation>
    </message>
    <message>
      <source>Record the same patterns at every exposure.</source>
      <translation>请在每个曝光录制相同的图案。</translation>
    </message>
    <message>
      <source>Record vertical and horizontal fringes at every position, for example a set named …-both of `measureapp patterns export`.</source>
      <translation>请在每个位置录制垂直和水平条纹，例如 `measureapp patterns export` 的名为 …-both 的图案集。</translation>
    </message>
    <message>
      <source>Reduce the cloud or mesh first.</source>
      <translation>请先减小点云或网格。</translation>
    </message>
    <message>
      <source>Remove the field, or calibrate again.</source>
      <translation>请移除该字段，或重新标定。</translation>
    </message>
    <message>
      <source>Restore both of its files from a backup, or calibrate again.</source>
      <translation>请从备份恢复其两个文件，或重新标定。</translation>
    </message>
    <message>
      <source>Restore it from a backup, or import the recording again.</source>
      <translation>请从备份恢复，或重新导入录制。</translation>
    </message>
    <message>
      <source>Restore it from a backup, or make a new one from what is there: measureapp verify PROJECT --renew-journal.</source>
      <translation>请从备份恢复，或由现有内容重新生成：measureapp verify PROJECT --renew-journal。</translation>
    </message>
    <message>
      <source>Restore it from a backup, or take the position again.</source>
      <translation>请从备份恢复，或重新拍摄该位置。</translation>
    </message>
    <message>
      <source>Restore it from a backup, or take the viewpoint again: measureapp discard PROJECT {viewpoint}, then measureapp scan … --resume.</source>
      <translation>请从备份恢复，或重新拍摄该视点：measureapp discard PROJECT {viewpoint}，然后 measureapp scan … --resume。</translation>
    </message>
    <message>
      <source>Restore it from a backup, or write a new one.</source>
      <translation>请从备份恢复，或写一个新的。</translation>
    </message>
    <message>
      <source>Restore it from a backup. If you changed it on purpose, accept it (measureapp verify PROJECT --accept {name}).</source>
      <translation>请从备份恢复。若是有意更改，请接受它 (measureapp verify PROJECT --accept {name})。</translation>
    </message>
    <message>
      <source>Restore the file from a backup, or create a new project.</source>
      <translation>请从备份恢复文件，或创建新项目。</translation>
    </message>
    <message>
      <source>Restore the file from a backup, or take the viewpoint again.</source>
      <translation>请从备份恢复该文件，或重新拍摄该视点。</translation>
    </message>
    <message>
      <source>Restore the file from a backup.</source>
      <translation>请从备份恢复文件。</translation>
    </message>
    <message>
      <source>Save it as ascii or (uncompressed) binary PCD, or as PLY.</source>
      <translation>请保存为 ascii 或（未压缩的）二进制 PCD，或 PLY。</translation>
    </message>
    <message>
      <source>Scan into a new project, or only add viewpoints.</source>
      <translation>请扫描到新项目，或只添加视点。</translation>
    </message>
    <message>
      <source>Scan the part again to compute it anew.</source>
      <translation>请重新扫描工件以重新计算。</translation>
    </message>
    <message>
      <source>See the format of cameras.json in the help.</source>
      <translation>cameras.json 的格式请见帮助。</translation>
    </message>
    <message>
      <source>Serial number {v1} was measured before ({v2}).</source>
      <translation>序列号 {v1} 此前已测量 ({v2})。</translation>
    </message>
    <message>
      <source>State --board-class or --certificate.</source>
      <translation>请给出 --board-class 或 --certificate。</translation>
    </message>
    <message>
      <source>State one of them.</source>
      <translation>请给出其一。</translation>
    </message>
    <message>
      <source>State who releases the part program.</source>
      <translation>请说明由谁发布工件程序。</translation>
    </message>
    <message>
      <source>Stitch again, or copy the file again.</source>
      <translation>请重新拼接，或重新复制文件。</translation>
    </message>
    <message>
      <source>Store it in the series of its own program.</source>
      <translation>请将其存入自己程序的系列。</translation>
    </message>
    <message>
      <source>Store only stacks taken by a rig in a project.</source>
      <translation>项目中只存储测量系统拍摄的图像组。</translation>
    </message>
    <message>
      <source>Take at least two images of each of several brightnesses.</source>
      <translation>请在多个亮度各拍摄至少两幅图像。</translation>
    </message>
    <message>
      <source>Take at least two images of every brightness in constant light.</source>
      <translation>请在恒定光下每个亮度拍摄至少两幅图像。</translation>
    </message>
    <message>
      <source>Take the view again, or restore the file from a backup.</source>
      <translation>请重拍视图，或从备份恢复文件。</translation>
    </message>
    <message>
      <source>Take the view again.</source>
      <translation>请重拍视图。</translation>
    </message>
    <message>
      <source>Take this viewpoint again, or restore the file from a backup.</source>
      <translation>请重新拍摄该视点，或从备份恢复该文件。</translation>
    </message>
    <message>
      <source>Take this viewpoint again.</source>
      <translation>请重拍此视点。</translation>
    </message>
    <message>
      <source>Temperature of the board: {v1}.</source>
      <translation>标定板的温度：{v1}。</translation>
    </message>
    <message>
      <source>The PIN has fewer than {v1} characters.</source>
      <translation>PIN 少于 {v1} 个字符。</translation>
    </message>
    <message>
      <source>The calibration in {v1} was modified after it was stored.</source>
      <translation>{v1} 中的标定在存储后被修改。</translation>
    </message>
    <message>
      <source>The cameras have different numbers of images ({v1}).</source>
      <translation>各相机的图像数量不同 ({v1})。</translation>
    </message>
    <message>
      <source>The columns of {v1} are in {v2}</source>
      <translation>{v1} 的各列以{v2}为单位</translation>
    </message>
    <message>
      <source>The columns of {v1} are in {v2}, and would be read as millimetres.</source>
      <translation>{v1} 的各列以{v2}为单位，却会按毫米读取。</translation>
    </message>
    <message>
      <source>The columns of {v1} are in {v2}, not in {v3}.</source>
      <translation>{v1} 的各列以{v2}为单位，而非{v3}。</translation>
    </message>
    <message>
      <source>The copy needs {v1} GB, and {v2} has {v3} GB left.</source>
      <translation>副本需要 {v1} GB，而 {v2} 剩余 {v3} GB。</translation>
    </message>
    <message>
      <source>The folder {v1} does not exist.</source>
      <translation>文件夹 {v1} 不存在。</translation>
    </message>
    <message>
      <source>The image of camera {v1} cannot be encoded.</source>
      <translation>相机 {v1} 的图像无法编码。</translation>
    </message>
    <message>
      <source>The images of {v1} were removed to save space.</source>
      <translation>{v1} 的图像已为节省空间而移除。</translation>
    </message>
    <message>
      <source>The inspection program</source>
      <translation>检测程序</translation>
    </message>
    <message>
      <source>The inspection program has no entry {v1}.</source>
      <translation>检测程序没有条目 {v1}。</translation>
    </message>
    <message>
      <source>The inspection program is not valid TOML: {v1}.</source>
      <translation>检测程序不是有效的 TOML：{v1}。</translation>
    </message>
    <message>
      <source>The joints form a closed loop.</source>
      <translation>关节构成闭环。</translation>
    </message>
    <message>
      <source>The noise model does not fit: {v1}.</source>
      <translation>噪声模型不适合：{v1}。</translation>
    </message>
    <message>
      <source>The path of {v1} is too long: it exceeds {v2} bytes.</source>
      <translation>{v1} 的路径太长：超过 {v2} 字节。</translation>
    </message>
    <message>
      <source>The project folder {v1} is gone.</source>
      <translation>项目文件夹 {v1} 已不存在。</translation>
    </message>
    <message>
      <source>The results in {v1} cannot be read: {v2}</source>
      <translation>无法读取 {v1} 中的结果：{v2}</translation>
    </message>
    <message>
      <source>The rig of {v1} has no camera {v2}.</source>
      <translation>{v1} 的测量系统没有相机 {v2}。</translation>
    </message>
    <message>
      <source>The root element is &lt;{v1}&gt;, not &lt;robot&gt;, as in a URDF.</source>
      <translation>根元素是 &lt;{v1}&gt;，而非 URDF 的 &lt;robot&gt;。</translation>
    </message>
    <message>
      <source>The run is of program {v1}, not {v2}.</source>
      <translation>该测量属于程序 {v1}，而非 {v2}。</translation>
    </message>
    <message>
      <source>The stack of {v1} has no axis read-back.</source>
      <translation>{v1} 的图像组没有轴的读回。</translation>
    </message>
    <message>
      <source>There are no images in {v1}.</source>
      <translation>{v1} 中没有图像。</translation>
    </message>
    <message>
      <source>There are {v1} revolute joints {v2}.</source>
      <translation>有 {v1} 个旋转关节{v2}。</translation>
    </message>
    <message>
      <source>There is no folder {v1}.</source>
      <translation>没有文件夹 {v1}。</translation>
    </message>
    <message>
      <source>There is no rig {v1}.</source>
      <translation>没有测量系统 {v1}。</translation>
    </message>
    <message>
      <source>There is no robot {v1}.</source>
      <translation>没有机器人 {v1}。</translation>
    </message>
    <message>
      <source>There is no {v1} in {v2} or its subfolders.</source>
      <translation>{v2} 及其子文件夹中没有 {v1}。</translation>
    </message>
    <message>
      <source>Too many wrong attempts. Wait {v1} s.</source>
      <translation>错误尝试过多。请等待 {v1} s。</translation>
    </message>
    <message>
      <source>Use .ply or .stl.</source>
      <translation>请使用 .ply 或 .stl。</translation>
    </message>
    <message>
      <source>Use .ply or .xyz.</source>
      <translation>请使用 .ply 或 .xyz。</translation>
    </message>
    <message>
      <source>Use an undamaged PNG, TIFF or BMP of 8 or 16 bit.</source>
      <translation>请使用未损坏的 8 位或 16 位 PNG、TIFF 或 BMP。</translation>
    </message>
    <message>
      <source>Use every image once.</source>
      <translation>每幅图像请只用一次。</translation>
    </message>
    <message>
      <source>Use images of one size for each camera.</source>
      <translation>每台相机请使用同一尺寸的图像。</translation>
    </message>
    <message>
      <source>Use one folder per board position, with its images and a {v1} as written by `measureapp patterns export`.</source>
      <translation>请为标定板的每个位置使用一个文件夹，其中有该位置的图像和由 `measureapp patterns export` 写出的 {v1}。</translation>
    </message>
    <message>
      <source>Use the calibration of the camera that took the images.</source>
      <translation>请使用拍摄这些图像的相机的标定。</translation>
    </message>
    <message>
      <source>Use the version of MeasureApp that wrote it.</source>
      <translation>请使用写出它的 MeasureApp 版本。</translation>
    </message>
    <message>
      <source>Wait until it has finished, or close it; then try again.</source>
      <translation>请等待其完成，或关闭它；然后重试。</translation>
    </message>
    <message>
      <source>Wait until that has finished, then try again.</source>
      <translation>请等待其完成，然后重试。</translation>
    </message>
    <message>
      <source>Write --images left='folder/left*.png'.</source>
      <translation>请写作 --images left='folder/left*.png'。</translation>
    </message>
    <message>
      <source>Write it as `calibration` of the help describes: number, temperature_c, uncertainty_mm, over_mm, and corners or scale.</source>
      <translation>请按帮助中 `calibration` 的说明书写：number、temperature_c、uncertainty_mm、over_mm，以及 corners 或 scale。</translation>
    </message>
    <message>
      <source>Write numbers with a decimal point.</source>
      <translation>请用小数点书写数字。</translation>
    </message>
    <message>
      <source>Write the file again with this version.</source>
      <translation>请用此版本重新写出文件。</translation>
    </message>
    <message>
      <source>Write the header {v1}{v2}.</source>
      <translation>请写表头 {v1}{v2}。</translation>
    </message>
    <message>
      <source>Write the manifest as `measureapp decode --help` describes.</source>
      <translation>请按 `measureapp decode --help` 的说明编写清单。</translation>
    </message>
    <message>
      <source>Write the recording as `measureapp import --help` describes.</source>
      <translation>请按 `measureapp import --help` 的说明书写该录制文件。</translation>
    </message>
    <message>
      <source>a file of schema_version 1</source>
      <translation>schema_version 1 的文件</translation>
    </message>
    <message>
      <source>a list of numbers</source>
      <translation>数值列表</translation>
    </message>
    <message>
      <source>a name begins with a letter or digit, and has letters, digits, '.', '_' and '-' only</source>
      <translation>名称以字母或数字开头，只含字母、数字、“.”、“_”和“-”</translation>
    </message>
    <message>
      <source>a scan plan</source>
      <translation>扫描计划</translation>
    </message>
    <message>
      <source>belongs to another stitched cloud</source>
      <translation>属于另一拼接点云</translation>
    </message>
    <message>
      <source>between {v1} and {v2}</source>
      <translation>在 {v1} 与 {v2} 之间</translation>
    </message>
    <message>
      <source>cannot be read</source>
      <translation>无法读取</translation>
    </message>
    <message>
      <source>corner {v1} occurs twice at position {v2}</source>
      <translation>角点 {v1} 在位置 {v2} 出现两次</translation>
    </message>
    <message>
      <source>false</source>
      <translation>false</translation>
    </message>
    <message>
      <source>give either pitch_px or periods</source>
      <translation>请给出 pitch_px 或 periods 之一</translation>
    </message>
    <message>
      <source>has format {v1}; this version reads format {v2}</source>
      <translation>格式为 {v1}；此版本读取格式 {v2}</translation>
    </message>
    <message>
      <source>is not what was stored</source>
      <translation>与存储的内容不符</translation>
    </message>
    <message>
      <source>it contains no surface, or is damaged</source>
      <translation>其中没有曲面，或已损坏</translation>
    </message>
    <message>
      <source>it has both corners and a scale, of which one would be ignored</source>
      <translation>同时含有角点和比例，其中之一会被忽略</translation>
    </message>
    <message>
      <source>it is no table</source>
      <translation>不是表格</translation>
    </message>
    <message>
      <source>it is not a text file</source>
      <translation>不是文本文件</translation>
    </message>
    <message>
      <source>it needs more than {v1} GiB of memory</source>
      <translation>需要超过 {v1} GiB 的内存</translation>
    </message>
    <message>
      <source>it unpacks to more than {v1} MB</source>
      <translation>解压后超过 {v1} MB</translation>
    </message>
    <message>
      <source>its array {v1} is cut off</source>
      <translation>其数组 {v1} 被截断</translation>
    </message>
    <message>
      <source>its cameras are not names</source>
      <translation>其相机不是名称</translation>
    </message>
    <message>
      <source>its name is not known</source>
      <translation>其名称未知</translation>
    </message>
    <message>
      <source>its values are nested too deeply</source>
      <translation>其值嵌套过深</translation>
    </message>
    <message>
      <source>its values are of other kinds</source>
      <translation>其值的类型不符</translation>
    </message>
    <message>
      <source>name = {v1}
alignment = "{v2}"
</source>
      <translation>name = {v1}
alignment = "{v2}"
</translation>
    </message>
    <message>
      <source>no index</source>
      <translation>没有索引</translation>
    </message>
    <message>
      <source>none</source>
      <translation>无</translation>
    </message>
    <message>
      <source>one finite number</source>
      <translation>一个有限数</translation>
    </message>
    <message>
      <source>planes</source>
      <translation>planes</translation>
    </message>
    <message>
      <source>position {v1} has two different angles</source>
      <translation>位置 {v1} 有两个不同的角度</translation>
    </message>
    <message>
      <source>position {v1} occurs twice</source>
      <translation>位置 {v1} 出现两次</translation>
    </message>
    <message>
      <source>steps</source>
      <translation>steps</translation>
    </message>
    <message>
      <source>the PIN</source>
      <translation>PIN</translation>
    </message>
    <message>
      <source>the certificate</source>
      <translation>证书</translation>
    </message>
    <message>
      <source>the first corner of a box must be below the second one in x, y and z</source>
      <translation>长方体的第一个角在 x、y、z 上都必须小于第二个角</translation>
    </message>
    <message>
      <source>the folder does not exist</source>
      <translation>该文件夹不存在</translation>
    </message>
    <message>
      <source>the index does not fit the file</source>
      <translation>索引与文件不符</translation>
    </message>
    <message>
      <source>the name {v1} is empty or occurs twice</source>
      <translation>名称 {v1} 为空或出现两次</translation>
    </message>
    <message>
      <source>the part program</source>
      <translation>工件程序</translation>
    </message>
    <message>
      <source>the quaternion (qw, qx, qy, qz) has length {v1}, not 1</source>
      <translation>四元数 (qw, qx, qy, qz) 的长度为 {v1}，而非 1</translation>
    </message>
    <message>
      <source>the robot</source>
      <translation>机器人</translation>
    </message>
    <message>
      <source>there is no vertex {v1}</source>
      <translation>没有顶点 {v1}</translation>
    </message>
    <message>
      <source>true</source>
      <translation>true</translation>
    </message>
    <message>
      <source>unknown error</source>
      <translation>未知错误</translation>
    </message>
    <message>
      <source>{v1} and the class {v2} both state the lengths of the board.</source>
      <translation>{v1} 与等级 {v2} 都给出了标定板的长度。</translation>
    </message>
    <message>
      <source>{v1} and {v2} are both image {v3} of camera {v4}.</source>
      <translation>{v1} 与 {v2} 都是相机 {v4} 的图像 {v3}。</translation>
    </message>
    <message>
      <source>{v1} cannot be opened: {v2}.</source>
      <translation>无法打开 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>{v1} cannot be read as a part program: {v2}.</source>
      <translation>{v1} 不能读作工件程序：{v2}。</translation>
    </message>
    <message>
      <source>{v1} cannot be read as a report template: {v2}.</source>
      <translation>{v1} 不能读作报告模板：{v2}。</translation>
    </message>
    <message>
      <source>{v1} cannot be read as {v2}: {v3}.</source>
      <translation>{v1} 不能读作 {v2}：{v3}。</translation>
    </message>
    <message>
      <source>{v1} cannot be written completely.</source>
      <translation>{v1} 无法完整写入。</translation>
    </message>
    <message>
      <source>{v1} cannot be written to.</source>
      <translation>无法写入 {v1}。</translation>
    </message>
    <message>
      <source>{v1} cannot be written to: {v2}.</source>
      <translation>无法写入 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>{v1} cannot be written: the disk is full.</source>
      <translation>{v1} 无法写入：磁盘已满。</translation>
    </message>
    <message>
      <source>{v1} cannot be written: there is a file in the place of a folder, or a folder in that of a file.</source>
      <translation>无法写入 {v1}：文件夹的位置上有文件，或文件的位置上有文件夹。</translation>
    </message>
    <message>
      <source>{v1} cannot hold a mesh.</source>
      <translation>{v1} 不能保存网格。</translation>
    </message>
    <message>
      <source>{v1} contains images of another plan.</source>
      <translation>{v1} 含有另一计划的图像。</translation>
    </message>
    <message>
      <source>{v1} contains noise models that do not fit their camera ({v2}).</source>
      <translation>{v1} 含有与其相机不符的噪声模型 ({v2})。</translation>
    </message>
    <message>
      <source>{v1} contains {v2}, which no part program has.</source>
      <translation>{v1} 含有 {v2}，工件程序中没有它。</translation>
    </message>
    <message>
      <source>{v1} could not be compressed without loss, and stays as it is.</source>
      <translation>{v1} 无法无损压缩，保持原样。</translation>
    </message>
    <message>
      <source>{v1} could not be tessellated: {v2}.</source>
      <translation>{v1} 无法三角化：{v2}。</translation>
    </message>
    <message>
      <source>{v1} declares a document type (DOCTYPE), which can hide entities.</source>
      <translation>{v1} 声明了文档类型 (DOCTYPE)，其中可能隐藏实体。</translation>
    </message>
    <message>
      <source>{v1} differs from its stored checksum</source>
      <translation>{v1} 与存储的校验和不符</translation>
    </message>
    <message>
      <source>{v1} differs from the group of the longest exposure.</source>
      <translation>{v1} 与最长曝光的组不同。</translation>
    </message>
    <message>
      <source>{v1} does not describe a stack: {v2}.</source>
      <translation>{v1} 没有描述图像组：{v2}。</translation>
    </message>
    <message>
      <source>{v1} does not exist or is not a file.</source>
      <translation>{v1} 不存在或不是文件。</translation>
    </message>
    <message>
      <source>{v1} does not hold a calibration: {v2}.</source>
      <translation>{v1} 中没有标定：{v2}。</translation>
    </message>
    <message>
      <source>{v1} does not hold results of a series.</source>
      <translation>{v1} 中没有系列的结果。</translation>
    </message>
    <message>
      <source>{v1} does not say whether it is ascii or binary.</source>
      <translation>{v1} 没有说明是 ascii 还是二进制。</translation>
    </message>
    <message>
      <source>{v1} ends with its header.</source>
      <translation>{v1} 在文件头之后结束。</translation>
    </message>
    <message>
      <source>{v1} finite numbers</source>
      <translation>{v1} 个有限数</translation>
    </message>
    <message>
      <source>{v1} gives different {v2}: {v3}.</source>
      <translation>{v1} 给出不同的{v2}：{v3}。</translation>
    </message>
    <message>
      <source>{v1} has a header that cannot be understood ({v2}).</source>
      <translation>{v1} 的文件头无法理解 ({v2})。</translation>
    </message>
    <message>
      <source>{v1} has a line in its header that cannot be understood: {v2}.</source>
      <translation>{v1} 的文件头中有一行无法理解：{v2}。</translation>
    </message>
    <message>
      <source>{v1} has a triangle that does not have three corners.</source>
      <translation>{v1} 有不是三个顶点的三角形。</translation>
    </message>
    <message>
      <source>{v1} has a vertex that is not three numbers.</source>
      <translation>{v1} 有不是三个数字的顶点。</translation>
    </message>
    <message>
      <source>{v1} has an axis of length 0.</source>
      <translation>{v1} 有长度为 0 的轴。</translation>
    </message>
    <message>
      <source>{v1} has different numbers of images ({v2}).</source>
      <translation>{v1} 的图像数量不同 ({v2})。</translation>
    </message>
    <message>
      <source>{v1} has no calibration.</source>
      <translation>{v1} 没有标定。</translation>
    </message>
    <message>
      <source>{v1} has no checksums.</source>
      <translation>{v1} 没有校验和。</translation>
    </message>
    <message>
      <source>{v1} has no evaluated dimensions.</source>
      <translation>{v1} 没有已评定的尺寸。</translation>
    </message>
    <message>
      <source>{v1} has no fields x, y and z.</source>
      <translation>{v1} 没有 x、y 和 z 字段。</translation>
    </message>
    <message>
      <source>{v1} has no journal yet.</source>
      <translation>{v1} 尚无日志。</translation>
    </message>
    <message>
      <source>{v1} has no parent or no child link.</source>
      <translation>{v1} 没有父连杆或子连杆。</translation>
    </message>
    <message>
      <source>{v1} has no phase-shift group.</source>
      <translation>{v1} 没有相移组。</translation>
    </message>
    <message>
      <source>{v1} has no read-back: {v2}.</source>
      <translation>{v1} 没有读回：{v2}。</translation>
    </message>
    <message>
      <source>{v1} has no rows of values.</source>
      <translation>{v1} 没有数值行。</translation>
    </message>
    <message>
      <source>{v1} has no vertices with x, y and z.</source>
      <translation>{v1} 没有含 x、y 和 z 的顶点。</translation>
    </message>
    <message>
      <source>{v1} has no vertices.</source>
      <translation>{v1} 没有顶点。</translation>
    </message>
    <message>
      <source>{v1} has no viewpoint {v2}.</source>
      <translation>{v1} 没有视点 {v2}。</translation>
    </message>
    <message>
      <source>{v1} has no {v2} in &lt;{v3}&gt;.</source>
      <translation>{v1} 在 &lt;{v3}&gt; 中没有 {v2}。</translation>
    </message>
    <message>
      <source>{v1} has no {v2}.</source>
      <translation>{v1} 没有{v2}。</translation>
    </message>
    <message>
      <source>{v1} has points but no triangles.</source>
      <translation>{v1} 有点但没有三角形。</translation>
    </message>
    <message>
      <source>{v1} has points of views that it does not describe.</source>
      <translation>{v1} 有它未描述的视图的点。</translation>
    </message>
    <message>
      <source>{v1} has the unknown format {v2}.</source>
      <translation>{v1} 的格式 {v2} 未知。</translation>
    </message>
    <message>
      <source>{v1} has triangles whose corners do not exist.</source>
      <translation>{v1} 有顶点不存在的三角形。</translation>
    </message>
    <message>
      <source>{v1} has {v2} GB free; the images need {v3} GB and {v4} GB more.</source>
      <translation>{v1} 可用空间为 {v2} GB；图像需要 {v3} GB，另需预留 {v4} GB。</translation>
    </message>
    <message>
      <source>{v1} has {v2} GiB, more than can be read at once.</source>
      <translation>{v1} 有 {v2} GiB，无法一次读取。</translation>
    </message>
    <message>
      <source>{v1} has {v2} fringes only; the projector calibration needs both directions.</source>
      <translation>{v1} 只有{v2}条纹；投影仪标定需要两个方向。</translation>
    </message>
    <message>
      <source>{v1} has {v2} images and needs at least {v3}.</source>
      <translation>{v1} 有 {v2} 幅图像，至少需要 {v3} 幅。</translation>
    </message>
    <message>
      <source>{v1} has {v2} images but {v3} = {v4}.</source>
      <translation>{v1} 有 {v2} 幅图像，但 {v3} = {v4}。</translation>
    </message>
    <message>
      <source>{v1} has {v2} vertices that are not usable numbers.</source>
      <translation>{v1} 有 {v2} 个不可用数值的顶点。</translation>
    </message>
    <message>
      <source>{v1} has {v2}; a certificate of the {v3} has one position with {v4} marks.</source>
      <translation>{v1} 有 {v2}；{v3}的证书有一个位置和 {v4} 个标记。</translation>
    </message>
    <message>
      <source>{v1} holds more than a report template.</source>
      <translation>{v1} 不只含报告模板。</translation>
    </message>
    <message>
      <source>{v1} holds no points.</source>
      <translation>{v1} 没有点。</translation>
    </message>
    <message>
      <source>{v1} holds something that is not a number.</source>
      <translation>{v1} 含有不是数字的内容。</translation>
    </message>
    <message>
      <source>{v1} is a STEP file, which states its unit itself.</source>
      <translation>{v1} 是 STEP 文件，它自己说明单位。</translation>
    </message>
    <message>
      <source>{v1} is a STEP file; the library that reads it is not installed.</source>
      <translation>{v1} 是 STEP 文件；未安装读取它的库。</translation>
    </message>
    <message>
      <source>{v1} is a folder.</source>
      <translation>{v1} 是文件夹。</translation>
    </message>
    <message>
      <source>{v1} is a plan of version {v2}; this version of MeasureApp reads versions up to {v3}.</source>
      <translation>{v1} 是版本 {v2} 的计划；此版本的 MeasureApp 读取到版本 {v3}。</translation>
    </message>
    <message>
      <source>{v1} is being written by another program.</source>
      <translation>{v1} 正由另一程序写入。</translation>
    </message>
    <message>
      <source>{v1} is cut short: it declares {v2} of element {v3} and holds fewer.</source>
      <translation>{v1} 不完整：它声明 {v2} 个元素 {v3}，实际较少。</translation>
    </message>
    <message>
      <source>{v1} is cut short: it declares {v2} points and holds fewer.</source>
      <translation>{v1} 不完整：它声明 {v2} 个点，实际较少。</translation>
    </message>
    <message>
      <source>{v1} is cut short: it declares {v2} triangles and holds {v3}.</source>
      <translation>{v1} 不完整：它声明 {v2} 个三角形，实际 {v3} 个。</translation>
    </message>
    <message>
      <source>{v1} is cut short: its last line is missing.</source>
      <translation>{v1} 不完整：缺少最后一行。</translation>
    </message>
    <message>
      <source>{v1} is damaged: it does not decompress to the images that were stored.</source>
      <translation>{v1} 已损坏：解压后不是所存储的图像。</translation>
    </message>
    <message>
      <source>{v1} is damaged: line {v2} is not the one that was stored.</source>
      <translation>{v1} 已损坏：第 {v2} 行不是所存储的内容。</translation>
    </message>
    <message>
      <source>{v1} is damaged: run {v2} cannot be read.</source>
      <translation>{v1} 已损坏：无法读取第 {v2} 次测量。</translation>
    </message>
    <message>
      <source>{v1} is damaged: run {v2} is not what was stored.</source>
      <translation>{v1} 已损坏：第 {v2} 次测量不是所存储的内容。</translation>
    </message>
    <message>
      <source>{v1} is damaged: what it says of its views' errors is not whole.</source>
      <translation>{v1} 已损坏：其视图误差的内容不完整。</translation>
    </message>
    <message>
      <source>{v1} is damaged: {v2}.</source>
      <translation>{v1} 已损坏：{v2}。</translation>
    </message>
    <message>
      <source>{v1} is empty.</source>
      <translation>{v1} 为空。</translation>
    </message>
    <message>
      <source>{v1} is in use by another program.</source>
      <translation>{v1} 正由另一程序使用。</translation>
    </message>
    <message>
      <source>{v1} is in use by another window or command: {v2}.</source>
      <translation>{v1} 正由另一窗口或命令使用：{v2}。</translation>
    </message>
    <message>
      <source>{v1} is inside the project that is copied.</source>
      <translation>{v1} 在被复制的项目之内。</translation>
    </message>
    <message>
      <source>{v1} is larger than {v2} MB.</source>
      <translation>{v1} 大于 {v2} MB。</translation>
    </message>
    <message>
      <source>{v1} is locked by another program, for example a backup.</source>
      <translation>{v1} 被另一程序锁定，例如备份。</translation>
    </message>
    <message>
      <source>{v1} is missing.</source>
      <translation>缺少 {v1}。</translation>
    </message>
    <message>
      <source>{v1} is not JSON.</source>
      <translation>{v1} 不是 JSON。</translation>
    </message>
    <message>
      <source>{v1} is not a MeasureApp project.</source>
      <translation>{v1} 不是 MeasureApp 项目。</translation>
    </message>
    <message>
      <source>{v1} is not a PCD file, or its header is damaged.</source>
      <translation>{v1} 不是 PCD 文件，或其文件头已损坏。</translation>
    </message>
    <message>
      <source>{v1} is not a PLY file, or its header is damaged.</source>
      <translation>{v1} 不是 PLY 文件，或其文件头已损坏。</translation>
    </message>
    <message>
      <source>{v1} is not a PNG image.</source>
      <translation>{v1} 不是 PNG 图像。</translation>
    </message>
    <message>
      <source>{v1} is not a STEP file.</source>
      <translation>{v1} 不是 STEP 文件。</translation>
    </message>
    <message>
      <source>{v1} is not a certificate of the {v2} with {v3} mm from mark to mark: a mark is {v4} mm from its place in the grid.</source>
      <translation>{v1} 不是标记间距 {v3} mm 的{v2}的证书：有标记距其网格位置 {v4} mm。</translation>
    </message>
    <message>
      <source>{v1} is not a date or time.</source>
      <translation>{v1} 不是日期或时间。</translation>
    </message>
    <message>
      <source>{v1} is not a file that can be accepted.</source>
      <translation>{v1} 不是可接受的文件。</translation>
    </message>
    <message>
      <source>{v1} is not a folder.</source>
      <translation>{v1} 不是文件夹。</translation>
    </message>
    <message>
      <source>{v1} is not a noise file: {v2}.</source>
      <translation>{v1} 不是噪声文件：{v2}。</translation>
    </message>
    <message>
      <source>{v1} is not a readable image.</source>
      <translation>{v1} 不是可读的图像。</translation>
    </message>
    <message>
      <source>{v1} is not a stitched cloud written by MeasureApp.</source>
      <translation>{v1} 不是 MeasureApp 写出的拼接点云。</translation>
    </message>
    <message>
      <source>{v1} is not a text file.</source>
      <translation>{v1} 不是文本文件。</translation>
    </message>
    <message>
      <source>{v1} is not a time such as 06:00</source>
      <translation>{v1} 不是时间，应如 06:00</translation>
    </message>
    <message>
      <source>{v1} is not a view's cloud written by MeasureApp.</source>
      <translation>{v1} 不是 MeasureApp 写出的视图点云。</translation>
    </message>
    <message>
      <source>{v1} is not an STL file.</source>
      <translation>{v1} 不是 STL 文件。</translation>
    </message>
    <message>
      <source>{v1} is not the id of a viewpoint</source>
      <translation>{v1} 不是视点的 ID</translation>
    </message>
    <message>
      <source>{v1} is not the journal of a project.</source>
      <translation>{v1} 不是项目的日志。</translation>
    </message>
    <message>
      <source>{v1} is not the name of a plan file.</source>
      <translation>{v1} 不是计划文件的名称。</translation>
    </message>
    <message>
      <source>{v1} is not valid TOML: its values are nested too deeply.</source>
      <translation>{v1} 不是有效的 TOML：其值嵌套过深。</translation>
    </message>
    <message>
      <source>{v1} is not valid XML: {v2}.</source>
      <translation>{v1} 不是有效的 XML：{v2}。</translation>
    </message>
    <message>
      <source>{v1} is not what was stored.</source>
      <translation>{v1} 不是所存储的内容。</translation>
    </message>
    <message>
      <source>{v1} is of an unknown kind.</source>
      <translation>{v1} 的类型未知。</translation>
    </message>
    <message>
      <source>{v1} is of type {v2}.</source>
      <translation>{v1} 的类型为 {v2}。</translation>
    </message>
    <message>
      <source>{v1} is stored as {v2}.</source>
      <translation>{v1} 已存储为 {v2}。</translation>
    </message>
    <message>
      <source>{v1} is the certificate of a board of {v2} × {v3} marks, {v4} mm apart; this is a {v5}, {v6} mm apart.</source>
      <translation>{v1} 是 {v2} × {v3} 个标记、间距 {v4} mm 的标定板的证书；此板为 {v5}，间距 {v6} mm。</translation>
    </message>
    <message>
      <source>{v1} is the only image of its brightness ({v2} grey levels); the nearest, {v3}, has {v4}.</source>
      <translation>{v1} 是其亮度（{v2} 灰度级）的唯一图像；最近的 {v3} 为 {v4}。</translation>
    </message>
    <message>
      <source>{v1} is the only image.</source>
      <translation>{v1} 是唯一的图像。</translation>
    </message>
    <message>
      <source>{v1} is {v2}, not a finite number</source>
      <translation>{v1} 为 {v2}，不是有限数</translation>
    </message>
    <message>
      <source>{v1} is {v2}, not a number</source>
      <translation>{v1} 为 {v2}，不是数字</translation>
    </message>
    <message>
      <source>{v1} is {v2}, not a whole number of at least 0</source>
      <translation>{v1} 为 {v2}，不是不小于 0 的整数</translation>
    </message>
    <message>
      <source>{v1} marks</source>
      <translation>{v1} 个标志点</translation>
    </message>
    <message>
      <source>{v1} moves, but is not {v2}: the chain branches.</source>
      <translation>{v1} 可移动，但不是 {v2}：链有分支。</translation>
    </message>
    <message>
      <source>{v1} names the image {v2} more than once.</source>
      <translation>{v1} 多次列出图像 {v2}。</translation>
    </message>
    <message>
      <source>{v1} names {v2}, which is no image file of this viewpoint.</source>
      <translation>{v1} 列出 {v2}，而它不是此视点的图像文件。</translation>
    </message>
    <message>
      <source>{v1} nests more than {v2} elements.</source>
      <translation>{v1} 嵌套超过 {v2} 个元素。</translation>
    </message>
    <message>
      <source>{v1} numbers</source>
      <translation>{v1} 个数值</translation>
    </message>
    <message>
      <source>{v1} positions</source>
      <translation>{v1} 个位置</translation>
    </message>
    <message>
      <source>{v1} says of its views what is not a number.</source>
      <translation>{v1} 对其视图的说明不是数字。</translation>
    </message>
    <message>
      <source>{v1} states units that are not one unit of length: {v2}.</source>
      <translation>{v1} 给出的单位不是同一长度单位：{v2}。</translation>
    </message>
    <message>
      <source>{v1} unpacks to more than {v2} GB.</source>
      <translation>{v1} 解压后超过 {v2} GB。</translation>
    </message>
    <message>
      <source>{v1} unpacks to more than {v2} MB.</source>
      <translation>{v1} 解压后超过 {v2} MB。</translation>
    </message>
    <message>
      <source>{v1} was not tessellated within {v2} s.</source>
      <translation>{v1} 未能在 {v2} s 内三角化。</translation>
    </message>
    <message>
      <source>{v1} was written by MeasureApp, in millimetres, not in {v2}.</source>
      <translation>{v1} 由 MeasureApp 以毫米写出，而非 {v2}。</translation>
    </message>
    <message>
      <source>{v1} was written by a newer version of MeasureApp (format {v2}; this version reads format {v3}).</source>
      <translation>{v1} 由更新版本的 MeasureApp 写出（格式 {v2}；此版本读取格式 {v3}）。</translation>
    </message>
    <message>
      <source>{v1} was written by a newer version of MeasureApp.</source>
      <translation>{v1} 由更新版本的 MeasureApp 写出。</translation>
    </message>
    <message>
      <source>{v1} {v2}: the stitched cloud is shown unfiltered.</source>
      <translation>{v1} {v2}：显示未过滤的拼接点云。</translation>
    </message>
    <message>
      <source>{v1}, camera {v2} was calibrated for {v3} × {v4} px.</source>
      <translation>{v1}，相机 {v2} 标定时为 {v3} × {v4} px。</translation>
    </message>
    <message>
      <source>{v1}, line 1: the column {v2} is missing.</source>
      <translation>{v1}，第 1 行：缺少列 {v2}。</translation>
    </message>
    <message>
      <source>{v1}, line 1: the column {v2} is unknown or occurs twice.</source>
      <translation>{v1}，第 1 行：列 {v2} 未知或出现两次。</translation>
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} cannot be understood.</source>
      <translation>{v1}，第 {v2} 行：无法理解 {v3}。</translation>
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} is not a point.</source>
      <translation>{v1}，第 {v2} 行：{v3} 不是点。</translation>
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} values under {v4} columns.</source>
      <translation>{v1}，第 {v2} 行：{v4} 列下有 {v3} 个值。</translation>
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} values where a point needs 3.</source>
      <translation>{v1} 第 {v2} 行：有 {v3} 个值，而一个点需要 3 个。</translation>
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} values where line {v4} has {v5}.</source>
      <translation>{v1}，第 {v2} 行：{v3} 个值，而第 {v4} 行有 {v5} 个。</translation>
    </message>
    <message>
      <source>{v1}, line {v2}: {v3}.</source>
      <translation>{v1}，第 {v2} 行：{v3}。</translation>
    </message>
    <message>
      <source>{v1}, process {v2}</source>
      <translation>{v1}，进程 {v2}</translation>
    </message>
    <message>
      <source>{v1}, the nominal named in {v2}, does not exist.</source>
      <translation>{v2} 中指定的名义模型 {v1} 不存在。</translation>
    </message>
    <message>
      <source>{v1}, user {v2} at {v3}, since {v4}</source>
      <translation>{v1}，用户 {v2}，位于 {v3}，自 {v4}</translation>
    </message>
    <message>
      <source>{v1}: 16-bit images need `saturation`.</source>
      <translation>{v1}：16 位图像需要 `saturation`。</translation>
    </message>
    <message>
      <source>{v1}: `periods` needs `{v2}`, the length they extend over.</source>
      <translation>{v1}：`periods` 需要 `{v2}`，即其延伸的长度。</translation>
    </message>
    <message>
      <source>{v1}: a group of horizontal fringes has projector_px.</source>
      <translation>{v1}：有水平条纹组含 projector_px。</translation>
    </message>
    <message>
      <source>{v1}: a single pitch of {v2} px leaves the period ambiguous.</source>
      <translation>{v1}：单一间距 {v2} px 使周期不明确。</translation>
    </message>
    <message>
      <source>{v1}: board_lengths.{v2}.</source>
      <translation>{v1}：board_lengths.{v2}。</translation>
    </message>
    <message>
      <source>{v1}: cameras names no camera.</source>
      <translation>{v1}：cameras 没有指定相机。</translation>
    </message>
    <message>
      <source>{v1}: covariance.matrix is not a covariance matrix: it must be symmetric and positive semidefinite.</source>
      <translation>{v1}：covariance.matrix 不是协方差矩阵：它必须对称且半正定。</translation>
    </message>
    <message>
      <source>{v1}: covariance.parameters has a label without a known camera.</source>
      <translation>{v1}：covariance.parameters 有标签不属于已知相机。</translation>
    </message>
    <message>
      <source>{v1}: covariance.parameters names a parameter twice.</source>
      <translation>{v1}：covariance.parameters 两次列出一个参数。</translation>
    </message>
    <message>
      <source>{v1}: exposure {v2} µs has {v3} groups, the first has {v4}.</source>
      <translation>{v1}：曝光 {v2} µs 有 {v3} 组，第一个有 {v4} 组。</translation>
    </message>
    <message>
      <source>{v1}: exposure {v2} µs, group {v3}</source>
      <translation>{v1}：曝光 {v2} µs，组 {v3}</translation>
    </message>
    <message>
      <source>{v1}: image {v2} cannot be read: it does not exist{v3}.</source>
      <translation>{v1}：无法读取图像 {v2}：它不存在{v3}。</translation>
    </message>
    <message>
      <source>{v1}: no corner is common to all positions.</source>
      <translation>{v1}：没有所有位置共有的角点。</translation>
    </message>
    <message>
      <source>{v1}: no position is further than {v2} mm from the origin.</source>
      <translation>{v1}：没有位置距原点超过 {v2} mm。</translation>
    </message>
    <message>
      <source>{v1}: only {v2} of {v3} positions have an angle.</source>
      <translation>{v1}：{v3} 个位置中只有 {v2} 个有角度。</translation>
    </message>
    <message>
      <source>{v1}: projector.name is {v2}, the name of a camera.</source>
      <translation>{v1}：projector.name 为 {v2}，是一台相机的名称。</translation>
    </message>
    <message>
      <source>{v1}: saturation = {v2}, but the images have {v3} bit.</source>
      <translation>{v1}：saturation = {v2}，但图像为 {v3} 位。</translation>
    </message>
    <message>
      <source>{v1}: schema_version is {v2}, not 1 or {v3}.</source>
      <translation>{v1}：schema_version 为 {v2}，而非 1 或 {v3}。</translation>
    </message>
    <message>
      <source>{v1}: the cameras have images of different bit depth.</source>
      <translation>{v1}：各相机的图像位深不同。</translation>
    </message>
    <message>
      <source>{v1}: the groups of exposure {v2} µs have different cameras.</source>
      <translation>{v1}：曝光 {v2} µs 的各组相机不同。</translation>
    </message>
    <message>
      <source>{v1}: the reference camera {v2} is not among the cameras.</source>
      <translation>{v1}：参考相机 {v2} 不在相机中。</translation>
    </message>
    <message>
      <source>{v1}: this is not a format for clouds.</source>
      <translation>{v1}：这不是点云文件的格式。</translation>
    </message>
    <message>
      <source>{v1}: this is not a format for meshes.</source>
      <translation>{v1}：这不是网格文件的格式。</translation>
    </message>
    <message>
      <source>{v1}: two exposures have the same exposure_us.</source>
      <translation>{v1}：两个曝光的 exposure_us 相同。</translation>
    </message>
    <message>
      <source>{v1}: {v2} does not match its checksum.</source>
      <translation>{v1}：{v2} 与其校验和不符。</translation>
    </message>
    <message>
      <source>{v1}: {v2} has the unknown field {v3}.</source>
      <translation>{v1}：{v2} 有未知字段 {v3}。</translation>
    </message>
    <message>
      <source>{v1}: {v2} is missing.</source>
      <translation>{v1}：缺少 {v2}。</translation>
    </message>
    <message>
      <source>{v1}: {v2} is not a JSON object.</source>
      <translation>{v1}：{v2} 不是 JSON 对象。</translation>
    </message>
    <message>
      <source>{v1}: {v2} is not a rigid 4×4 transform.</source>
      <translation>{v1}：{v2} 不是 4×4 刚性变换。</translation>
    </message>
    <message>
      <source>{v1}: {v2} is not a rigid transform.</source>
      <translation>{v1}：{v2} 不是刚性变换。</translation>
    </message>
    <message>
      <source>{v1}: {v2} is not a text.</source>
      <translation>{v1}：{v2} 不是文本。</translation>
    </message>
    <message>
      <source>{v1}: {v2} is not {v3}.</source>
      <translation>{v1}：{v2} 不是 {v3}。</translation>
    </message>
    <message>
      <source>{v1}: {v2} periods over {v3} px give a pitch below 2 px.</source>
      <translation>{v1}：{v3} px 上的 {v2} 个周期使间距小于 2 px。</translation>
    </message>
    <message>
      <source>{v1}: {v2} pitches need projector_px.</source>
      <translation>{v1}：{v2} 个间距需要 projector_px。</translation>
    </message>
    <message>
      <source>{v1}: {v2}.arguments is not a list of strings.</source>
      <translation>{v1}：{v2}.arguments 不是字符串列表。</translation>
    </message>
    <message>
      <source>{v1}: {v2}.blur_px is {v3}, not 0 to {v4} px.</source>
      <translation>{v1}：{v2}.blur_px 为 {v3}，不在 0 至 {v4} px 内。</translation>
    </message>
    <message>
      <source>{v1}: {v2}.distortion has {v3} coefficients.</source>
      <translation>{v1}：{v2}.distortion 有 {v3} 个系数。</translation>
    </message>
    <message>
      <source>{v1}: {v2}.matrix is not a camera matrix.</source>
      <translation>{v1}：{v2}.matrix 不是相机矩阵。</translation>
    </message>
    <message>
      <source>{v1}: {v2}.reference_from_camera is not the identity for the reference camera.</source>
      <translation>{v1}：对参考相机，{v2}.reference_from_camera 不是恒等变换。</translation>
    </message>
    <message>
      <source>{v1}: {v2}.width and height must be whole numbers above 0.</source>
      <translation>{v1}：{v2}.width 和 height 必须是大于 0 的整数。</translation>
    </message>
    <message>
      <source>{v1}: {v2}.{v3} is not a number.</source>
      <translation>{v1}：{v2}.{v3} 不是数字。</translation>
    </message>
    <message>
      <source>{v1}: {v2}={v3} is not numeric.</source>
      <translation>{v1}：{v2}={v3} 不是数值。</translation>
    </message>
    <message>
      <source>{v1}: {v2}={v3} should be {v4}.</source>
      <translation>{v1}：{v2}={v3} 应为 {v4}。</translation>
    </message>
    <message>
      <source>{v1}: {v2}{v3} is missing.</source>
      <translation>{v1}：缺少 {v2}{v3}。</translation>
    </message>
    <message>
      <source>{v1}; the first image of camera {v2} is {v3} × {v4} px.</source>
      <translation>{v1}；相机 {v2} 的第一幅图像为 {v3} × {v4} px。</translation>
    </message>
    <message>
      <source>{v1}{v2} is not a known key</source>
      <translation>{v1}{v2} 不是已知的键</translation>
    </message>
  </context>
  <context>
    <name>core.projector_lightcrafter</name>
    <message>
      <source>Check exposure, period and trigger settings against its manual.</source>
      <translation>请对照手册检查曝光、周期和触发设置。</translation>
    </message>
    <message>
      <source>Check its power and its USB cable, then connect again.</source>
      <translation>请检查其电源和 USB 电缆，然后重新连接。</translation>
    </message>
    <message>
      <source>Check its power and its USB cable.</source>
      <translation>请检查其电源和 USB 电缆。</translation>
    </message>
    <message>
      <source>Check the USB cable, and close other programs that use the projector.</source>
      <translation>请检查 USB 电缆，并关闭使用投影仪的其他程序。</translation>
    </message>
    <message>
      <source>Choose a period of {v1} µs or more, or a pattern set of at most {v2} images.</source>
      <translation>请选择不短于 {v1} µs 的周期，或最多 {v2} 幅图像的图案集。</translation>
    </message>
    <message>
      <source>Choose a period of {v1} µs or more.</source>
      <translation>请选择不短于 {v1} µs 的周期。</translation>
    </message>
    <message>
      <source>Choose {v1} µs or more.</source>
      <translation>请选择不小于 {v1} µs。</translation>
    </message>
    <message>
      <source>Close other programs that use it; on Linux, allow access by a udev rule (see the README of the driver).</source>
      <translation>请关闭使用它的其他程序；在 Linux 上，请用 udev 规则允许访问（见驱动的 README）。</translation>
    </message>
    <message>
      <source>Close other programs that use the projector, and check the limits in its manual.</source>
      <translation>请关闭使用投影仪的其他程序，并检查其手册中的限值。</translation>
    </message>
    <message>
      <source>Close other programs that use the projector.</source>
      <translation>请关闭使用投影仪的其他程序。</translation>
    </message>
    <message>
      <source>Connect the rig again.</source>
      <translation>请重新连接测量系统。</translation>
    </message>
    <message>
      <source>Correct the rig description, or choose another driver.</source>
      <translation>请更正测量系统描述，或选择另一驱动。</translation>
    </message>
    <message>
      <source>Correct the setting flash, or program the images with the vendor's tool.</source>
      <translation>请更正设置 flash，或用供应商的工具写入图像。</translation>
    </message>
    <message>
      <source>Correct the setting flash.</source>
      <translation>请更正设置 flash。</translation>
    </message>
    <message>
      <source>Correct the setting video.</source>
      <translation>请更正设置 video。</translation>
    </message>
    <message>
      <source>Divide the pattern set.</source>
      <translation>请拆分图案集。</translation>
    </message>
    <message>
      <source>Export it by `measureapp patterns export --width {v1} --height {v2}`, program the images with the vendor's tool, three patterns to an image (green, red, blue), and add hash {v3} with their numbers to the setting flash.</source>
      <translation>请用 `measureapp patterns export --width {v1} --height {v2}` 导出，用供应商的工具写入图像，每幅图像三个图案（绿、红、蓝），并将哈希 {v3} 及其编号加到设置 flash。</translation>
    </message>
    <message>
      <source>Give 8-bit images of {v1} × {v2} px.</source>
      <translation>请给出 {v1} × {v2} px 的 8 位图像。</translation>
    </message>
    <message>
      <source>Install it: pip install hidapi</source>
      <translation>请安装：pip install hidapi</translation>
    </message>
    <message>
      <source>Load them with this driver's model.</source>
      <translation>请用此驱动的模型加载。</translation>
    </message>
    <message>
      <source>Name one of them in the setting serial.</source>
      <translation>请在设置 serial 中指定其一。</translation>
    </message>
    <message>
      <source>Play again.</source>
      <translation>请重新播放。</translation>
    </message>
    <message>
      <source>Replace it: pip uninstall hid; pip install hidapi</source>
      <translation>请更换：pip uninstall hid; pip install hidapi</translation>
    </message>
    <message>
      <source>Rig {v1}: the projector has {v2} × {v3} px, and a LightCrafter 4500 {v4} × {v5}.</source>
      <translation>测量系统 {v1}：投影仪为 {v2} × {v3} px，而 LightCrafter 4500 为 {v4} × {v5}。</translation>
    </message>
    <message>
      <source>Rig {v1}: the settings of the screen at the video port: {v2}.</source>
      <translation>测量系统 {v1}：视频端口的屏幕设置：{v2}。</translation>
    </message>
    <message>
      <source>Set the screen to a frame time of {v1} µs or more, such as 60 Hz.</source>
      <translation>请将屏幕的帧时间设为 {v1} µs 以上，例如 60 Hz。</translation>
    </message>
    <message>
      <source>Stop other programs that use the projector; if it stays so, switch it off and on again.</source>
      <translation>请停止使用投影仪的其他程序；若仍如此，请关闭后重新打开。</translation>
    </message>
    <message>
      <source>Switch it off and on again.</source>
      <translation>请关闭后重新打开。</translation>
    </message>
    <message>
      <source>Switch it off and on again; if it stays so, it is defective.</source>
      <translation>请关闭后重新打开；若仍如此，则已损坏。</translation>
    </message>
    <message>
      <source>Switch it off at its power supply.</source>
      <translation>请在其电源处关闭。</translation>
    </message>
    <message>
      <source>The driver of the LightCrafter needs the package hidapi, and another package provides its module hid.</source>
      <translation>LightCrafter 的驱动需要 hidapi 包，而其模块 hid 由另一个包提供。</translation>
    </message>
    <message>
      <source>The driver of the LightCrafter needs the package hidapi.</source>
      <translation>LightCrafter 的驱动需要 hidapi 包。</translation>
    </message>
    <message>
      <source>Update its firmware.</source>
      <translation>请更新其固件。</translation>
    </message>
    <message>
      <source>Update its firmware; this one takes the command for one run as the one for repetition.</source>
      <translation>请更新其固件；此版本将单次运行的命令当作重复命令。</translation>
    </message>
    <message>
      <source>a pattern that waits for an external trigger follows without a black field</source>
      <translation>等待外部触发的图案之前没有黑场</translation>
    </message>
    <message>
      <source>a report could not be sent</source>
      <translation>某个报告无法发送</translation>
    </message>
    <message>
      <source>an image buffer was swapped too late</source>
      <translation>某个图像缓冲区交换过迟</translation>
    </message>
    <message>
      <source>flash images are numbered 0…255</source>
      <translation>闪存图像的编号为 0…255</translation>
    </message>
    <message>
      <source>has {v1} bytes, and a reply begins with {v2}</source>
      <translation>有 {v1} 字节，而应答以 {v2} 字节开头</translation>
    </message>
    <message>
      <source>it has not initialised itself</source>
      <translation>它尚未完成初始化</translation>
    </message>
    <message>
      <source>its USB connection broke</source>
      <translation>其 USB 连接中断</translation>
    </message>
    <message>
      <source>its memory test failed</source>
      <translation>其存储器测试失败</translation>
    </message>
    <message>
      <source>its sequencer does not run</source>
      <translation>其序列器没有运行</translation>
    </message>
    <message>
      <source>no data</source>
      <translation>没有数据</translation>
    </message>
    <message>
      <source>one without a serial number</source>
      <translation>一台没有序列号</translation>
    </message>
    <message>
      <source>states a length of {v1} bytes; the longest reply has {v2}</source>
      <translation>声明长度为 {v1} 字节；最长的应答为 {v2} 字节</translation>
    </message>
    <message>
      <source>table of {v1}</source>
      <translation>{v1} 的表</translation>
    </message>
    <message>
      <source>the command {v1} ({v2}:{v3})</source>
      <translation>命令 {v1}（{v2}:{v3}）</translation>
    </message>
    <message>
      <source>the controller of the mirrors reports an error</source>
      <translation>微镜控制器报告错误</translation>
    </message>
    <message>
      <source>the exposure or the period is not valid</source>
      <translation>曝光或周期无效</translation>
    </message>
    <message>
      <source>the mirrors are parked</source>
      <translation>微镜已停放</translation>
    </message>
    <message>
      <source>the period exceeds the exposure by less than {v1} µs</source>
      <translation>周期超出曝光的部分不足 {v1} µs</translation>
    </message>
    <message>
      <source>the sequencer reports an error</source>
      <translation>序列器报告错误</translation>
    </message>
    <message>
      <source>the sequencer stopped before the end of the sequence</source>
      <translation>序列器在序列结束之前停止</translation>
    </message>
    <message>
      <source>the table has a pattern number that is not valid</source>
      <translation>表中有无效的图案编号</translation>
    </message>
    <message>
      <source>to {v1} has {v2} bytes of data instead of {v3}</source>
      <translation>对 {v1} 有 {v2} 字节数据，而非 {v3} 字节</translation>
    </message>
    <message>
      <source>trigger output 1 stays high, or black fields overlap</source>
      <translation>触发输出 1 保持高电平，或黑场重叠</translation>
    </message>
    <message>
      <source>unknown bits 0x{v1}</source>
      <translation>未知位 0x{v1}</translation>
    </message>
    <message>
      <source>{v1} answers earlier requests only, not {v2}.</source>
      <translation>{v1} 只应答更早的请求，未应答 {v2}。</translation>
    </message>
    <message>
      <source>{v1} cannot expose {v2} µs in a period of {v3} µs.</source>
      <translation>{v1} 无法在 {v3} µs 的周期内曝光 {v2} µs。</translation>
    </message>
    <message>
      <source>{v1} cannot show patterns of {v2} bits for {v3} µs.</source>
      <translation>{v1} 无法以 {v3} µs 显示 {v2} 位的图案。</translation>
    </message>
    <message>
      <source>{v1} did not answer {v2} within {v3} s.</source>
      <translation>{v1} 在 {v3} s 内没有应答 {v2}。</translation>
    </message>
    <message>
      <source>{v1} did not finish checking the sequence.</source>
      <translation>{v1} 没有完成序列的检查。</translation>
    </message>
    <message>
      <source>{v1} did not start the sequence: {v2}.</source>
      <translation>{v1} 没有开始序列：{v2}。</translation>
    </message>
    <message>
      <source>{v1} did not switch its light off.</source>
      <translation>{v1} 没有关闭其光源。</translation>
    </message>
    <message>
      <source>{v1} did not take over the setting {v2}: {v3} was written, {v4} was read back.</source>
      <translation>{v1} 没有采用设置 {v2}：写入 {v3}，读回 {v4}。</translation>
    </message>
    <message>
      <source>{v1} does not accept the sequence: {v2}.</source>
      <translation>{v1} 不接受该序列：{v2}。</translation>
    </message>
    <message>
      <source>{v1} does not answer any more: {v2}.</source>
      <translation>{v1} 不再应答：{v2}。</translation>
    </message>
    <message>
      <source>{v1} does not support images of shape {v2} and type {v3}.</source>
      <translation>{v1} 不支持形状 {v2}、类型 {v3} 的图像。</translation>
    </message>
    <message>
      <source>{v1} has {v2} images and cannot play {v3}…{v4}.</source>
      <translation>{v1} 有 {v2} 幅图像，不能播放 {v3}…{v4}。</translation>
    </message>
    <message>
      <source>{v1} has {v2} images and cannot show image {v3}.</source>
      <translation>{v1} 有 {v2} 幅图像，不能显示图像 {v3}。</translation>
    </message>
    <message>
      <source>{v1} has {v2} images in flash, and the settings name others ({v3}).</source>
      <translation>{v1} 的闪存中有 {v2} 幅图像，而设置指定了其他 ({v3})。</translation>
    </message>
    <message>
      <source>{v1} needs {v2} ms to load flash image {v3}, and shows the one before it for {v4} ms only.</source>
      <translation>{v1} 载入闪存图像 {v3} 需要 {v2} ms，而前一幅只显示 {v4} ms。</translation>
    </message>
    <message>
      <source>{v1} plays at most {v2} patterns from {v3} images at once, not {v4} from {v5}.</source>
      <translation>{v1} 一次最多播放来自 {v3} 幅图像的 {v2} 个图案，不能播放来自 {v5} 幅的 {v4} 个。</translation>
    </message>
    <message>
      <source>{v1} refused {v2} ({v3}; reply {v4}).</source>
      <translation>{v1} 拒绝 {v2}（{v3}；应答 {v4}）。</translation>
    </message>
    <message>
      <source>{v1} reports a fault: {v2}.</source>
      <translation>{v1} 报告故障：{v2}。</translation>
    </message>
    <message>
      <source>{v1} reports a fault: {v2}. The number of its trigger pulses is unknown.</source>
      <translation>{v1} 报告故障：{v2}。其触发脉冲数未知。</translation>
    </message>
    <message>
      <source>{v1} returned an empty table of {v2}.</source>
      <translation>{v1} 返回了空的{v2}表。</translation>
    </message>
    <message>
      <source>{v1} still plays {v2} s after the start of a sequence of {v3} s: it repeats the patterns, and the number of its trigger pulses is unknown.</source>
      <translation>在 {v3} s 的序列开始后 {v2} s，{v1} 仍在播放：它重复图案，其触发脉冲数未知。</translation>
    </message>
    <message>
      <source>{v1} stopped {v2} s after the start of a sequence of {v3} s: the number of its trigger pulses is unknown.</source>
      <translation>{v1} 在 {v3} s 的序列开始后 {v2} s 停止：其触发脉冲数未知。</translation>
    </message>
    <message>
      <source>{v1} was released.</source>
      <translation>{v1} 已被释放。</translation>
    </message>
    <message>
      <source>{v1}: a reply to {v2} has the sequence number {v3} instead of {v4} ({v5}).</source>
      <translation>{v1}：对 {v2} 的应答序号为 {v3} 而非 {v4} ({v5})。</translation>
    </message>
    <message>
      <source>{v1}: a reply {v2} ({v3}).</source>
      <translation>{v1}：应答 {v2} ({v3})。</translation>
    </message>
    <message>
      <source>{v1}: image {v2}</source>
      <translation>{v1}：图像 {v2}</translation>
    </message>
    <message>
      <source>{v1}: the LightCrafter is present and cannot be opened: {v2}.</source>
      <translation>{v1}：LightCrafter 存在但无法打开：{v2}。</translation>
    </message>
    <message>
      <source>{v1}: the pattern set of {v2} images ({v3}) is not in its flash (declared: {v4}).</source>
      <translation>{v1}：{v2} 幅图像的图案集 ({v3}) 不在其闪存中（已声明：{v4}）。</translation>
    </message>
    <message>
      <source>{v1}: the pattern set {v2} ({v3}) has {v4} images, three to a flash image, and the settings name {v5} flash images.</source>
      <translation>{v1}：图案集 {v2} ({v3}) 有 {v4} 幅图像，每幅闪存图像三个，而设置指定了 {v5} 幅闪存图像。</translation>
    </message>
    <message>
      <source>{v1}: the screen at its video port has a frame time of {v2} µs, too short for 8 bits.</source>
      <translation>{v1}：其视频端口的屏幕帧时间为 {v2} µs，对 8 位太短。</translation>
    </message>
    <message>
      <source>{v1}: the settings are not those of a LightCrafter.</source>
      <translation>{v1}：这些设置不是 LightCrafter 的。</translation>
    </message>
    <message>
      <source>{v1}: there is {v2} on the USB (found: {v3}).</source>
      <translation>{v1}：USB 上有 {v2}（找到：{v3}）。</translation>
    </message>
  </context>
  <context>
    <name>core.projector_second_screen</name>
    <message>
      <source>Check that the program has a display (not over ssh), and that PySide6 is installed.</source>
      <translation>请检查程序有显示器（不经 ssh），且已安装 PySide6。</translation>
    </message>
    <message>
      <source>Rig {v1}: the settings of the projector name no screen.</source>
      <translation>测量系统 {v1}：投影仪的设置没有指定屏幕。</translation>
    </message>
    <message>
      <source>Set frame_us, such as 16667 for 60 Hz.</source>
      <translation>请设置 frame_us，例如 60 Hz 为 16667。</translation>
    </message>
    <message>
      <source>Set name, manufacturer, model or serial; `python -m ui.second_screen list` prints the screens.</source>
      <translation>请设置 name、manufacturer、model 或 serial；`python -m ui.second_screen list` 打印屏幕列表。</translation>
    </message>
    <message>
      <source>its window did not appear within {v1} s</source>
      <translation>其窗口在 {v1} s 内没有出现</translation>
    </message>
    <message>
      <source>its window was closed</source>
      <translation>其窗口已关闭</translation>
    </message>
    <message>
      <source>the process of its window ended with code {v1}{v2}</source>
      <translation>其窗口的进程已结束，代码 {v1}{v2}</translation>
    </message>
    <message>
      <source>the process of its window has ended</source>
      <translation>其窗口的进程已结束</translation>
    </message>
    <message>
      <source>{v1}: the screen does not state its refresh rate.</source>
      <translation>{v1}：屏幕没有说明其刷新率。</translation>
    </message>
    <message>
      <source>{v1}: the settings are not those of a second screen.</source>
      <translation>{v1}：这些设置不是第二屏幕的。</translation>
    </message>
    <message>
      <source>{v1}: the window did not follow the command {v2} within {v3} s.</source>
      <translation>{v1}：窗口在 {v3} s 内没有执行命令 {v2}。</translation>
    </message>
  </context>
  <context>
    <name>core.reconstruct</name>
    <message>
      <source> The orthogonal fringes give no {v1} there: {v2}.</source>
      <translation> 正交条纹在那里没有给出{v1}：{v2}。</translation>
    </message>
    <message>
      <source> and </source>
      <translation> 和 </translation>
    </message>
    <message>
      <source> {v1} were not matched: {v2}.</source>
      <translation> {v1} 未匹配：{v2}。</translation>
    </message>
    <message>
      <source>A camera of the pair looks along the baseline.</source>
      <translation>相机对中有一台沿基线方向观察。</translation>
    </message>
    <message>
      <source>A rectified grid needs two cameras, not {v1}.</source>
      <translation>校正网格需要两台相机，而非 {v1}。</translation>
    </message>
    <message>
      <source>Add the images of a second camera.</source>
      <translation>请添加第二台相机的图像。</translation>
    </message>
    <message>
      <source>Another camera sees a projector line there that differs from {lit} by more than {sigmas:g} standard deviations plus {px:g} px: reflections, or a camera that moved. Check the epipolar residual of the viewpoint.</source>
      <translation>另一台相机在那里看到的投影仪条纹线与{lit}相差超过 {sigmas:g} 倍标准差加 {px:g} px：反射，或某台相机移动了。请检查该视点的极线残差。</translation>
    </message>
    <message>
      <source>At a depth discontinuity, where blur mixes in the light from beyond the border of its surface. Add a viewpoint from which it is not at a border.</source>
      <translation>位于深度不连续处，模糊混入了其表面边界之外的光。请增加一个使它不在边界上的视点。</translation>
    </message>
    <message>
      <source>At a depth discontinuity, where the pixel covers two surfaces at once. Another viewpoint sees them apart.</source>
      <translation>位于深度不连续处，该像素同时覆盖两个表面。从另一个视点可将它们分开。</translation>
    </message>
    <message>
      <source>Beside a saturated pixel that spills over. Add a shorter exposure.</source>
      <translation>在溢出的饱和像素旁边。请增加更短的曝光。</translation>
    </message>
    <message>
      <source>Camera {v1} and the projector give no points: {v2} pixels are {v3}.</source>
      <translation>相机 {v1} 与投影仪没有给出点：{v2} 个像素为{v3}。</translation>
    </message>
    <message>
      <source>Camera {v1} has no pixel in row {v2}, column {v3}.</source>
      <translation>相机 {v1} 在第 {v2} 行第 {v3} 列没有像素。</translation>
    </message>
    <message>
      <source>Camera {v1} has no pixel with a phase.</source>
      <translation>相机 {v1} 没有有相位的像素。</translation>
    </message>
    <message>
      <source>Camera {v1} is calibrated for {v2} × {v3} px, its images have {v4} × {v5} px.</source>
      <translation>相机 {v1} 按 {v2} × {v3} px 标定，其图像为 {v4} × {v5} px。</translation>
    </message>
    <message>
      <source>Camera {v1} is not in the calibration of {v2}.</source>
      <translation>相机 {v1} 不在 {v2} 的标定中。</translation>
    </message>
    <message>
      <source>Cameras {v1} and {v2} are at one place.</source>
      <translation>相机 {v1} 与 {v2} 在同一位置。</translation>
    </message>
    <message>
      <source>Cameras {v1} and {v2} have no epipolar line in common.</source>
      <translation>相机 {v1} 与 {v2} 没有共同的极线。</translation>
    </message>
    <message>
      <source>Cameras {v1} and {v2} look along their baseline.</source>
      <translation>相机 {v1} 与 {v2} 沿其基线方向观察。</translation>
    </message>
    <message>
      <source>Change the sign of shift_sign, reverse the order of the phase-shifted images, or check whether the projector is mounted upside down.</source>
      <translation>请更改 shift_sign 的符号、颠倒相移图像的顺序，或检查投影仪是否倒装。</translation>
    </message>
    <message>
      <source>Check shift_sign and the pitches, and that the calibration belongs to this camera and projector.</source>
      <translation>请检查 shift_sign 和节距，以及标定是否属于此相机和投影仪。</translation>
    </message>
    <message>
      <source>Check shift_sign, the pitches and that the calibration belongs to these images.</source>
      <translation>请检查 shift_sign、间距，以及标定是否属于这些图像。</translation>
    </message>
    <message>
      <source>Check that the calibration belongs to these images and their order.</source>
      <translation>请检查标定是否属于这些图像及其顺序。</translation>
    </message>
    <message>
      <source>Check that the calibration belongs to these images, and that the cameras see the same part.</source>
      <translation>请检查标定是否属于这些图像，以及各相机是否看到同一工件。</translation>
    </message>
    <message>
      <source>Check the fringe direction of the pattern set, and whether images are rotated by 90°.</source>
      <translation>请检查图案集的条纹方向，以及图像是否旋转了 90°。</translation>
    </message>
    <message>
      <source>Check the pitches and projector_px of the pattern set, or calibrate the projector again.</source>
      <translation>请检查图案集的节距和 projector_px，或重新标定投影仪。</translation>
    </message>
    <message>
      <source>Check the pitches of the pattern set, and that the calibration belongs to this projector and its resolution.</source>
      <translation>请检查图案集的节距，以及标定是否属于此投影仪及其分辨率。</translation>
    </message>
    <message>
      <source>Check whether the images of {v1} are rotated by 180° or mirrored, and whether the calibration belongs to them.</source>
      <translation>请检查 {v1} 的图像是否旋转了 180° 或镜像，以及标定是否属于它们。</translation>
    </message>
    <message>
      <source>Choose the grid of the images.</source>
      <translation>请选择图像的网格。</translation>
    </message>
    <message>
      <source>Decode the images of one pattern set.</source>
      <translation>请解码同一图案集的图像。</translation>
    </message>
    <message>
      <source>Either shift_sign is wrong, or the projector (or the reference camera) is mounted upside down. Change shift_sign, or calibrate the projector: its calibration distinguishes the two.</source>
      <translation>要么 shift_sign 错误，要么投影仪（或参考相机）倒装。请更改 shift_sign，或标定投影仪：其标定可区分二者。</translation>
    </message>
    <message>
      <source>Exchange them, for instance in the manifest: </source>
      <translation>请交换它们，例如在清单中： </translation>
    </message>
    <message>
      <source>Exchange them, for instance in the manifest: {v1}.</source>
      <translation>请将它们互换，例如在清单中：{v1}。</translation>
    </message>
    <message>
      <source>Exclude one of the cameras.</source>
      <translation>请排除其中一台相机。</translation>
    </message>
    <message>
      <source>Exclude one of them.</source>
      <translation>请排除其一。</translation>
    </message>
    <message>
      <source>Fewer than {neighbours} of 24 places around it lie on the same surface: it is at a depth discontinuity or isolated.</source>
      <translation>在其周围 24 处中，同一表面上的少于 {neighbours} 处：它位于深度不连续处或是孤立的。</translation>
    </message>
    <message>
      <source>Fringes of this direction cannot match the cameras {v1}: {v2}.</source>
      <translation>此方向的条纹不能匹配相机 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>Further from the plane through its neighbours than {outlier:g} standard deviations.</source>
      <translation>距其邻点平面的距离大于 {outlier:g} 倍标准差。</translation>
    </message>
    <message>
      <source>Give cameras.json a projector, or use two cameras.</source>
      <translation>请给 cameras.json 一个投影仪，或使用两台相机。</translation>
    </message>
    <message>
      <source>Grazing incidence on another camera of the point: more than {partner:g}° off the normal.</source>
      <translation>在该点的另一台相机上为掠入射：偏离法线超过 {partner:g}°。</translation>
    </message>
    <message>
      <source>Grazing incidence: the camera sees the surface more than {incidence:g}° off its normal. Turn the part towards the sensor.</source>
      <translation>掠入射：相机看到的表面偏离其法线超过 {incidence:g}°。请将工件转向测头。</translation>
    </message>
    <message>
      <source>Isolated patch: its connected component has fewer than {min_pixels} pixels.</source>
      <translation>孤立碎片：其连通区域少于 {min_pixels} 个像素。</translation>
    </message>
    <message>
      <source>It has a point.</source>
      <translation>它有一个点。</translation>
    </message>
    <message>
      <source>Its images have {v1} rows and {v2} columns.</source>
      <translation>其图像有 {v1} 行 {v2} 列。</translation>
    </message>
    <message>
      <source>Measured by an earlier camera already: the point is in that camera's image.</source>
      <translation>已由前面的相机测得：该点在那台相机的图像中。</translation>
    </message>
    <message>
      <source>Name one of: </source>
      <translation>请从中选择： </translation>
    </message>
    <message>
      <source>No other camera has the {lit} on the epipolar line: it is occluded from them, or outside their images. Add a viewpoint.</source>
      <translation>没有其他相机在极线上看到{lit}：它被遮挡，或在其图像之外。请增加一个视点。</translation>
    </message>
    <message>
      <source>Not reached by the projector's light: modulation {modulation:.1f} grey levels. Turn the part or add a viewpoint.</source>
      <translation>投影仪的光没有照到：调制度 {modulation:.1f} 灰度级。请转动工件或增加一个视点。</translation>
    </message>
    <message>
      <source>One of {v1} has moved since its calibration: check the mountings and calibrate again.</source>
      <translation>{v1} 之一在标定后移动了：请检查安装并重新标定。</translation>
    </message>
    <message>
      <source>Only one camera sees the {lit}, which gives no depth. Add a second camera, or calibrate the projector.</source>
      <translation>只有一台相机看到{lit}，无法得到深度。请增加第二台相机，或标定投影仪。</translation>
    </message>
    <message>
      <source>Only {v1} of the phases of {v2} have a match on their epipolar line in {v3}, in front of both cameras.</source>
      <translation>{v2} 的相位中只有 {v1} 在 {v3} 的极线上、两台相机前方有匹配。</translation>
    </message>
    <message>
      <source>Only {v1} of the phases of {v2} intersect their projector column in front of the camera.</source>
      <translation>{v2} 的相位中只有 {v1} 在相机前方与其投影仪列相交。</translation>
    </message>
    <message>
      <source>Orthogonal fringes of {v1} in {v2}</source>
      <translation>{v2} 中 {v1} 的正交条纹</translation>
    </message>
    <message>
      <source>Points of {v1} and {v2} in {v3}</source>
      <translation>{v3} 中 {v1} 和 {v2} 的点</translation>
    </message>
    <message>
      <source>Project fringes of the other direction, or both.</source>
      <translation>请投射另一方向或两个方向的条纹。</translation>
    </message>
    <message>
      <source>Saturated in every exposure: {grey:.0f} of {saturation:.0f} grey levels. Add a shorter exposure.</source>
      <translation>在每次曝光中都饱和：{saturation:.0f} 灰度级中的 {grey:.0f}。请增加更短的曝光。</translation>
    </message>
    <message>
      <source>The calibrated projector deviates by {v1} columns from the points of two cameras.</source>
      <translation>已标定的投影仪与两台相机的点相差 {v1} 列。</translation>
    </message>
    <message>
      <source>The fringe orders of the pitches contradict each other, at modulation {modulation:.1f} grey levels. Use patterns with more pitches, or a longer exposure.</source>
      <translation>各节距的条纹级次相互矛盾，调制度 {modulation:.1f} 灰度级。请使用节距更多的图案，或更长的曝光。</translation>
    </message>
    <message>
      <source>The fringes in the images of {v1} are orthogonal to those of the calibrated projector.</source>
      <translation>{v1} 图像中的条纹与已标定投影仪的条纹正交。</translation>
    </message>
    <message>
      <source>The image has {v1} columns; at least {v2} are needed.</source>
      <translation>图像有 {v1} 列；至少需要 {v2} 列。</translation>
    </message>
    <message>
      <source>The images of camera {v1} have {v2} columns; at least {v3} are needed.</source>
      <translation>相机 {v1} 的图像有 {v2} 列；至少需要 {v3} 列。</translation>
    </message>
    <message>
      <source>The images of {v1} appear to be exchanged.</source>
      <translation>{v1} 的图像似乎被交换了。</translation>
    </message>
    <message>
      <source>The images of {v1} contradict the calibration: matched points have phase residuals of {v2} px.</source>
      <translation>{v1} 的图像与标定矛盾：匹配点的相位残差为 {v2} px。</translation>
    </message>
    <message>
      <source>The phase decreases from left to right in the images of {v1}.</source>
      <translation>在 {v1} 的图像中，相位从左到右减小。</translation>
    </message>
    <message>
      <source>The phase lies outside the projector's image: light arrives by a reflection, or the order is wrong.</source>
      <translation>相位位于投影仪图像之外：光经反射到达，或级次错误。</translation>
    </message>
    <message>
      <source>The phase maps of the cameras are of different pitches.</source>
      <translation>各相机的相位图间距不同。</translation>
    </message>
    <message>
      <source>The phase of {v1} increases against the columns of the calibrated projector.</source>
      <translation>{v1} 的相位逆着已标定投影仪的列方向增大。</translation>
    </message>
    <message>
      <source>The phase of {v1} increases in the opposite direction to that of the other cameras and the projector.</source>
      <translation>{v1} 的相位增大方向与其他相机和投影仪相反。</translation>
    </message>
    <message>
      <source>The phase of {v1} increases in the opposite direction to that of the other cameras.</source>
      <translation>{v1} 的相位增大方向与其他相机相反。</translation>
    </message>
    <message>
      <source>The phases reach projector column {v1}, but the calibrated projector has {v2} columns.</source>
      <translation>相位达到投影仪第 {v1} 列，而已标定的投影仪只有 {v2} 列。</translation>
    </message>
    <message>
      <source>The predicted standard deviation exceeds {max_sigma:.2g} mm and three times the median of the view: phase noise {sigma:.4f} rad. Add a longer exposure.</source>
      <translation>预测的标准差超过 {max_sigma:.2g} mm 及该视图中值的三倍：相位噪声 {sigma:.4f} rad。请增加更长的曝光。</translation>
    </message>
    <message>
      <source>The predicted standard deviation exceeds {max_sigma:.2g} mm: phase noise {sigma:.4f} rad. Add a longer exposure.</source>
      <translation>预测的标准差超过 {max_sigma:.2g} mm：相位噪声 {sigma:.4f} rad。请增加更长的曝光。</translation>
    </message>
    <message>
      <source>The projector columns of the phases are {v1} times those of the calibrated projector.</source>
      <translation>相位的投影仪列是已标定投影仪的 {v1} 倍。</translation>
    </message>
    <message>
      <source>The projector illuminates the surface more than {partner:g}° off its normal.</source>
      <translation>投影仪照射表面的方向偏离其法线超过 {partner:g}°。</translation>
    </message>
    <message>
      <source>The projector or a camera has moved: calibrate the projector again, and do not use its points until then.</source>
      <translation>投影仪或某台相机移动了：请重新标定投影仪，在此之前不要使用其点。</translation>
    </message>
    <message>
      <source>The region has no pixel of camera {v1}.</source>
      <translation>该区域没有相机 {v1} 的像素。</translation>
    </message>
    <message>
      <source>The view has no camera {v1}.</source>
      <translation>该视图没有相机 {v1}。</translation>
    </message>
    <message>
      <source>The viewing ray does not meet the {lit} in front of the camera and inside the projector's image: a wrong fringe order, light from a reflection, or the calibration of another projector.</source>
      <translation>视线在相机前方、投影仪图像之内没有与{lit}相交：条纹级次错误、来自反射的光，或是另一台投影仪的标定。</translation>
    </message>
    <message>
      <source>The viewing ray is nearly parallel to the surface that the {lit} illuminates, so that the depth is undetermined. Move the projector or the camera apart, or add fringes of the other direction.</source>
      <translation>视线几乎平行于{lit}照射的表面，因此深度无法确定。请将投影仪与相机分开，或增加另一方向的条纹。</translation>
    </message>
    <message>
      <source>The {lit} belong to no point of the viewing ray, by more than {sigmas:g} standard deviations plus {px:g} px: reflections, or a projector or camera that moved.</source>
      <translation>{lit}不属于视线上的任何点，相差超过 {sigmas:g} 倍标准差加 {px:g} px：反射，或投影仪或相机移动了。</translation>
    </message>
    <message>
      <source>The {lit} occurs at several places of an epipolar line, or hardly changes along it: a wrong fringe order, or fringes along the line.</source>
      <translation>{lit}在一条极线上多处出现，或沿极线几乎不变：条纹级次错误，或条纹与极线平行。</translation>
    </message>
    <message>
      <source>Too little of the light follows the pattern: modulation {modulation:.1f} at {grey:.0f} grey levels. Add a longer exposure, shade ambient light, or dull a shiny surface.</source>
      <translation>跟随图案的光太少：在 {grey:.0f} 灰度级时调制度 {modulation:.1f}。请增加更长的曝光、遮挡环境光，或使反光表面变暗。</translation>
    </message>
    <message>
      <source>Use images of the whole sensor.</source>
      <translation>请使用整个传感器的图像。</translation>
    </message>
    <message>
      <source>Use larger images.</source>
      <translation>请使用更大的图像。</translation>
    </message>
    <message>
      <source>Use the calibration of the camera and resolution that took the images.</source>
      <translation>请使用拍摄这些图像的相机和分辨率的标定。</translation>
    </message>
    <message>
      <source>behind the camera or the projector</source>
      <translation>位于相机或投影仪后方</translation>
    </message>
    <message>
      <source>distortion of the projector has no inverse</source>
      <translation>投影仪的畸变没有逆</translation>
    </message>
    <message>
      <source>filling {v1}</source>
      <translation>正在填充 {v1}</translation>
    </message>
    <message>
      <source>matching {v1}</source>
      <translation>正在匹配 {v1}</translation>
    </message>
    <message>
      <source>module {v1} has no attribute {v2}</source>
      <translation>模块 {v1} 没有属性 {v2}</translation>
    </message>
    <message>
      <source>outside the projector's image</source>
      <translation>位于投影仪图像之外</translation>
    </message>
    <message>
      <source>parallel to the projector's fringe</source>
      <translation>与投影仪的条纹平行</translation>
    </message>
    <message>
      <source>point of the projector</source>
      <translation>投影仪的点</translation>
    </message>
    <message>
      <source>projector </source>
      <translation>投影仪 </translation>
    </message>
    <message>
      <source>projector's column and row contradict each other</source>
      <translation>投影仪的列与行相互矛盾</translation>
    </message>
    <message>
      <source>{v1} calibrated camera has images; points need two.</source>
      <translation>{v1} 台已标定相机有图像；点需要两台。</translation>
    </message>
    <message>
      <source>{v1} have a systematic residual of {v2} px, about {v3} mm of depth; phase noise explains {v4} px.</source>
      <translation>{v1}有 {v2} px 的系统残差，约合 {v3} mm 深度；相位噪声可解释 {v4} px。</translation>
    </message>
  </context>
  <context>
    <name>core.register</name>
    <message>
      <source>A cloud of {v1} points has no point with {v2} neighbours.</source>
      <translation>{v1} 个点的点云中没有一个点有 {v2} 个邻点。</translation>
    </message>
    <message>
      <source>A set-up needs at least {v1}; scan more of the part.</source>
      <translation>一次装夹至少需要 {v1}；请扫描工件的更多部分。</translation>
    </message>
    <message>
      <source>A sphere was moved between the set-ups, or one of them is measured badly: fasten the spheres and scan again.</source>
      <translation>某个球在装夹之间移动了，或其中一个测量不佳：请固定各球并重新扫描。</translation>
    </message>
    <message>
      <source>Add a set-up that sees more of both (the part on its edge), or join by the nominal or by at least three reference spheres.</source>
      <translation>请添加一次能同时看到两者更多部分的装夹（工件立起），或通过名义模型或至少三个参考球拼接。</translation>
    </message>
    <message>
      <source>All points of the cloud coincide.</source>
      <translation>点云的所有点重合。</translation>
    </message>
    <message>
      <source>At least one cloud needs {v1} points.</source>
      <translation>至少一个点云需要 {v1} 个点。</translation>
    </message>
    <message>
      <source>At least {v1} are needed.</source>
      <translation>至少需要 {v1}。</translation>
    </message>
    <message>
      <source>By their reference spheres, {v1} and {v2} contradict each other: points of one are where the other one saw empty space.</source>
      <translation>按参考球，{v1} 与 {v2} 相互矛盾：一方的点位于另一方所见的空处。</translation>
    </message>
    <message>
      <source>Check that both are of the same part and that it was not changed between the set-ups; remove fixtures from the clouds.</source>
      <translation>请检查两者是否为同一工件、装夹之间是否有改动；并从点云中去除夹具。</translation>
    </message>
    <message>
      <source>Check that the spheres were not moved between the set-ups and that both are of one part.</source>
      <translation>请检查装夹之间各球是否移动，以及两者是否为同一工件。</translation>
    </message>
    <message>
      <source>Check the calibration.</source>
      <translation>请检查标定。</translation>
    </message>
    <message>
      <source>Check the normals and the density of the cloud.</source>
      <translation>请检查点云的法线和密度。</translation>
    </message>
    <message>
      <source>Check the unit and the frame of the cloud.</source>
      <translation>请检查点云的单位和坐标系。</translation>
    </message>
    <message>
      <source>Check their diameter, and scan every sphere in both set-ups.</source>
      <translation>请检查其直径，并在两次装夹中扫描每个球。</translation>
    </message>
    <message>
      <source>Correct --turned {v1}=…: the rotation of the part about x, then y, then z, from the first set-up.</source>
      <translation>请更正 --turned {v1}=…：工件相对第一次装夹依次绕 x、y、z 的转动。</translation>
    </message>
    <message>
      <source>Free disk space there.</source>
      <translation>请在该处腾出磁盘空间。</translation>
    </message>
    <message>
      <source>Give each axis from the smaller to the larger value.</source>
      <translation>请从小到大给出每个轴的值。</translation>
    </message>
    <message>
      <source>Give one pose per cloud.</source>
      <translation>请为每个点云给出一个位姿。</translation>
    </message>
    <message>
      <source>Give six rows and columns per view.</source>
      <translation>请为每个视图给出六行六列。</translation>
    </message>
    <message>
      <source>Give the direction of the side to keep.</source>
      <translation>请给出要保留一侧的方向。</translation>
    </message>
    <message>
      <source>Make a closed surface (poisson), or divide the cloud into open patches.</source>
      <translation>请生成封闭曲面 (poisson)，或将点云分成开放的片。</translation>
    </message>
    <message>
      <source>Merge on a coarser grid, close other programs, and check the cloud's normals.</source>
      <translation>请用更粗的网格合并，关闭其他程序，并检查点云的法向。</translation>
    </message>
    <message>
      <source>Merge on a coarser grid, or close other programs.</source>
      <translation>请用更粗的网格合并，或关闭其他程序。</translation>
    </message>
    <message>
      <source>No cloud has enough points for registration.</source>
      <translation>没有点云有足够的点用于配准。</translation>
    </message>
    <message>
      <source>No position of {v1} fits near the stated rotation; the nearest is {v2}° away from it.</source>
      <translation>在所述转动附近没有适合 {v1} 的位置；最近的相差 {v2}°。</translation>
    </message>
    <message>
      <source>No view can be used: each contradicts its kinematic position.</source>
      <translation>没有可用的视图：每个都与其运动学位置矛盾。</translation>
    </message>
    <message>
      <source>Only {v1} reference spheres were found in {v2}; at least {v3} are needed.</source>
      <translation>在 {v2} 中只找到 {v1} 个参考球；至少需要 {v3} 个。</translation>
    </message>
    <message>
      <source>Place the spheres at unequal distances, or state --turned {v1}=X,Y,Z.</source>
      <translation>请将各球以不等间距放置，或给出 --turned {v1}=X,Y,Z。</translation>
    </message>
    <message>
      <source>Scan more of the surface in both set-ups, join them by reference spheres, or check that both are of one part.</source>
      <translation>请在两次装夹中扫描更多表面、通过参考球拼接，或检查两者是否为同一工件。</translation>
    </message>
    <message>
      <source>Separate the numbers by commas.</source>
      <translation>请用逗号分隔数字。</translation>
    </message>
    <message>
      <source>State it: --sphere-diameter-mm.</source>
      <translation>请给出：--sphere-diameter-mm。</translation>
    </message>
    <message>
      <source>State roughly how the part was turned, for example --turned {v1}=180,0,0 (about x, y, z), or use reference spheres.</source>
      <translation>请大致给出工件的转动，例如 --turned {v1}=180,0,0（绕 x、y、z），或使用参考球。</translation>
    </message>
    <message>
      <source>State the rotation --turned {v1}=… more precisely.</source>
      <translation>请更精确地给出转动 --turned {v1}=…。</translation>
    </message>
    <message>
      <source>The box is empty: a lower limit exceeds its upper limit.</source>
      <translation>盒子为空：某下限超过其上限。</translation>
    </message>
    <message>
      <source>The covariance of {v1} poses has shape {v2}.</source>
      <translation>{v1} 个位姿的协方差的形状为 {v2}。</translation>
    </message>
    <message>
      <source>The diameter of the reference spheres is missing.</source>
      <translation>缺少参考球的直径。</translation>
    </message>
    <message>
      <source>The filter {v1} needs {v2} numbers.</source>
      <translation>过滤器 {v1} 需要 {v2} 个数字。</translation>
    </message>
    <message>
      <source>The filter {v1} removes all points.</source>
      <translation>过滤器 {v1} 去除了所有点。</translation>
    </message>
    <message>
      <source>The plane normal is 0 0 0.</source>
      <translation>平面法向为 0 0 0。</translation>
    </message>
    <message>
      <source>The points do not form a surface.</source>
      <translation>这些点不构成曲面。</translation>
    </message>
    <message>
      <source>The points lie on one line.</source>
      <translation>这些点位于一条直线上。</translation>
    </message>
    <message>
      <source>The points of the surface cannot be written to {v1}: {v2}.</source>
      <translation>无法将曲面的点写入 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>The reference spheres of {v1} and {v2} can be assigned in {v3} ways.</source>
      <translation>{v1} 与 {v2} 的参考球有 {v3} 种对应方式。</translation>
    </message>
    <message>
      <source>The reference spheres of {v1} and {v2} contradict each other: the sphere at {v3} mm is {v4} mm off the others, the limit is {v5} mm.</source>
      <translation>{v1} 与 {v2} 的参考球相互矛盾：位于 {v3} mm 处的球与其他球相差 {v4} mm，限值为 {v5} mm。</translation>
    </message>
    <message>
      <source>The reference spheres of {v1} and {v2} do not correspond: no three have the same distances within {v3} mm.</source>
      <translation>{v1} 与 {v2} 的参考球不对应：没有三个球的间距在 {v3} mm 以内相同。</translation>
    </message>
    <message>
      <source>The surface needs about {v1} GiB of memory, and {v2} GiB are free.</source>
      <translation>曲面约需 {v1} GiB 内存，而空闲 {v2} GiB。</translation>
    </message>
    <message>
      <source>The surface reconstruction could not be started: {v1}.</source>
      <translation>无法启动曲面重建：{v1}。</translation>
    </message>
    <message>
      <source>The surface reconstruction failed: {v1}.</source>
      <translation>曲面重建失败：{v1}。</translation>
    </message>
    <message>
      <source>The surface that {v1} has in common with the other set-ups does not determine: {v2}.</source>
      <translation>{v1} 与其他装夹的共有表面不能确定：{v2}。</translation>
    </message>
    <message>
      <source>The views contradict the calibrated axes in one pattern: what is left between them {follows} ({size_mm:.3f} mm rms beyond the stated errors). The views are kept and the uncertainties contain it; {what} is doubted. {remedy}</source>
      <translation>各视图以同一规律与标定的轴相矛盾：其间的残差{follows}（超出所述误差 {size_mm:.3f} mm rms）。视图已保留，不确定度已包含它；存疑的是{what}。{remedy}</translation>
    </message>
    <message>
      <source>There are {v1} clouds but {v2} poses.</source>
      <translation>有 {v1} 个点云，但有 {v2} 个位姿。</translation>
    </message>
    <message>
      <source>There are {v1} filters already.</source>
      <translation>已有 {v1} 个过滤器。</translation>
    </message>
    <message>
      <source>Two positions of {v1} fit equally well, {v2}° and {v3}° away from the stated rotation.</source>
      <translation>{v1} 有两个同样合适的位置，与所述转动相差 {v2}° 和 {v3}°。</translation>
    </message>
    <message>
      <source>Undo some, or apply fewer and stricter ones.</source>
      <translation>请撤销一些，或使用更少、更严格的。</translation>
    </message>
    <message>
      <source>Use a larger cloud or fewer neighbours.</source>
      <translation>请使用更大的点云或更少的邻点。</translation>
    </message>
    <message>
      <source>Use the same spheres in both set-ups, and do not move them between the set-ups.</source>
      <translation>请在两次装夹中使用相同的球，且不要在装夹之间移动。</translation>
    </message>
    <message>
      <source>Widen it. Nothing was changed.</source>
      <translation>请放宽。未作任何更改。</translation>
    </message>
    <message>
      <source>building the search tree</source>
      <translation>正在建立搜索树</translation>
    </message>
    <message>
      <source>filter: {v1}</source>
      <translation>过滤器：{v1}</translation>
    </message>
    <message>
      <source>finding the position of {v1}</source>
      <translation>正在求 {v1} 的位置</translation>
    </message>
    <message>
      <source>its surface lies {v1} mm and {v2}° off its kinematic position, {v3} times the limit</source>
      <translation>其表面偏离运动学位置 {v1} mm、{v2}°，为限值的 {v3} 倍</translation>
    </message>
    <message>
      <source>joint registration</source>
      <translation>联合配准</translation>
    </message>
    <message>
      <source>no overlap with another view: kinematic position</source>
      <translation>与其他视图没有重叠：采用运动学位置</translation>
    </message>
    <message>
      <source>only {v1} of the surface at the same place fits within {v2} mm</source>
      <translation>同一位置的表面只有 {v1} 在 {v2} mm 以内相符</translation>
    </message>
    <message>
      <source>only {v1} of the visible surface has points</source>
      <translation>可见表面只有 {v1} 有点</translation>
    </message>
    <message>
      <source>only {v1} points</source>
      <translation>只有 {v1} 个点</translation>
    </message>
    <message>
      <source>only {v1} points per mm²</source>
      <translation>每 mm² 只有 {v1} 个点</translation>
    </message>
    <message>
      <source>only {v1} points: excluded</source>
      <translation>只有 {v1} 个点：已排除</translation>
    </message>
    <message>
      <source>out of memory</source>
      <translation>内存不足</translation>
    </message>
    <message>
      <source>point noise of {v1} mm</source>
      <translation>点噪声 {v1} mm</translation>
    </message>
    <message>
      <source>preparing set-ups</source>
      <translation>正在准备各次装夹</translation>
    </message>
    <message>
      <source>preparing views</source>
      <translation>正在准备视图</translation>
    </message>
    <message>
      <source>registering pairs of views</source>
      <translation>正在配准视图对</translation>
    </message>
    <message>
      <source>removing long triangles</source>
      <translation>正在去除长三角形</translation>
    </message>
    <message>
      <source>rotation about {v1} through {v2} mm</source>
      <translation>绕 {v1} 过 {v2} mm 的旋转</translation>
    </message>
    <message>
      <source>searching neighbours</source>
      <translation>正在搜索邻点</translation>
    </message>
    <message>
      <source>surface complete</source>
      <translation>表面已完成</translation>
    </message>
    <message>
      <source>surface distortion of {v1} mm</source>
      <translation>表面畸变 {v1} mm</translation>
    </message>
    <message>
      <source>translation along {v1}</source>
      <translation>沿 {v1} 的平移</translation>
    </message>
    <message>
      <source>triangulating the points</source>
      <translation>正在将点三角化</translation>
    </message>
    <message>
      <source>trimming the surface</source>
      <translation>正在修整表面</translation>
    </message>
    <message>
      <source>unreachable: there is at least one position</source>
      <translation>不可达：至少有一个位置</translation>
    </message>
    <message>
      <source>{v1} do not fit in any position: {v2}.</source>
      <translation>{v1} 在任何位置都不相合：{v2}。</translation>
    </message>
    <message>
      <source>{v1} has no error model.</source>
      <translation>{v1} 没有误差模型。</translation>
    </message>
    <message>
      <source>{v1} has only {v2} points for registration.</source>
      <translation>{v1} 只有 {v2} 个点可用于配准。</translation>
    </message>
    <message>
      <source>{v1} have too little surface in common: at most {v2} of the smaller one, {v3} are needed.</source>
      <translation>{v1} 的共有表面太少：最多为较小者的 {v2}，需要 {v3}。</translation>
    </message>
    <message>
      <source>{v1} of the points face away from the rest: this is not a single open patch.</source>
      <translation>{v1} 的点背向其余的点：这不是单一的开放片。</translation>
    </message>
    <message>
      <source>{v1} of the points have no neighbours in the projection along the mean normal: surfaces overlap there, or the points are scattered.</source>
      <translation>{v1} 的点在沿平均法线的投影中没有相邻点：该处曲面重叠，或点是散乱的。</translation>
    </message>
    <message>
      <source>{v1} of the points of one are where the other one saw empty space</source>
      <translation>一方有 {v1} 的点位于另一方所见的空处</translation>
    </message>
    <message>
      <source>{v1} outliers</source>
      <translation>{v1} 离群点</translation>
    </message>
    <message>
      <source>{v1} points are too few for a surface.</source>
      <translation>{v1} 个点太少，无法生成曲面。</translation>
    </message>
    <message>
      <source>{v1} positions of {v2} relative to {v3} fit equally well: the part is symmetric.</source>
      <translation>{v2} 相对 {v3} 有 {v1} 个同样合适的位置：工件是对称的。</translation>
    </message>
    <message>
      <source>{v1}: accepted by hand</source>
      <translation>{v1}：手动接受</translation>
    </message>
    <message>
      <source>{v1}: excluded</source>
      <translation>{v1}：已排除</translation>
    </message>
  </context>
  <context>
    <name>core.report</name>
    <message>
      <source>95 % interval {low} … {high}</source>
      <translation>95 % 区间 {low} … {high}</translation>
    </message>
    <message>
      <source>95 % within</source>
      <translation>95 % 以内</translation>
    </message>
    <message>
      <source>About the alignment</source>
      <translation>关于对齐</translation>
    </message>
    <message>
      <source>Add measured projects: measureapp series add PROJECT.</source>
      <translation>请添加已测项目：measureapp series add PROJECT。</translation>
    </message>
    <message>
      <source>Alignment to the nominal</source>
      <translation>与名义模型的对齐</translation>
    </message>
    <message>
      <source>Alignment: {name}. Positive: outside the nominal. Hatched: not measured within {reach} mm.</source>
      <translation>对齐：{name}。正值：在名义表面之外。阴影线：{reach} mm 内未测量。</translation>
    </message>
    <message>
      <source>All dimensions</source>
      <translation>全部尺寸</translation>
    </message>
    <message>
      <source>All dimensions refer to the alignment by {name}.</source>
      <translation>所有尺寸均以{name}对齐为参考。</translation>
    </message>
    <message>
      <source>All {v1} dimensions pass.</source>
      <translation>全部 {v1} 个尺寸合格。</translation>
    </message>
    <message>
      <source>All {v1} dimensions with a tolerance pass; {v2} without tolerance.</source>
      <translation>有公差的 {v1} 个尺寸全部合格；{v2} 个无公差。</translation>
    </message>
    <message>
      <source>Balloon</source>
      <translation>气泡号</translation>
    </message>
    <message>
      <source>Below, above</source>
      <translation>低于、高于</translation>
    </message>
    <message>
      <source>Calibration age</source>
      <translation>标定距测量的时间</translation>
    </message>
    <message>
      <source>Camera drift check</source>
      <translation>相机漂移检查</translation>
    </message>
    <message>
      <source>Cameras {name}</source>
      <translation>相机对 {name}</translation>
    </message>
    <message>
      <source>Check the path of the logo.</source>
      <translation>请检查徽标的路径。</translation>
    </message>
    <message>
      <source>Checked</source>
      <translation>审核</translation>
    </message>
    <message>
      <source>Checked: name, date, signature</source>
      <translation>审核：姓名、日期、签名</translation>
    </message>
    <message>
      <source>Checks of the error model</source>
      <translation>误差模型的检查</translation>
    </message>
    <message>
      <source>Cloud and alignment</source>
      <translation>点云与对齐</translation>
    </message>
    <message>
      <source>Comparison of nominal and measured dimensions</source>
      <translation>名义尺寸与实测尺寸的比较</translation>
    </message>
    <message>
      <source>Complete</source>
      <translation>完整性</translation>
    </message>
    <message>
      <source>Confidence level</source>
      <translation>置信水平</translation>
    </message>
    <message>
      <source>Contributions to U (k = 2)</source>
      <translation>对 U 的贡献 (k = 2)</translation>
    </message>
    <message>
      <source>Control frame</source>
      <translation>公差框格</translation>
    </message>
    <message>
      <source>Correct `layout` in {v1}.</source>
      <translation>请更正 {v1} 中的 `layout`。</translation>
    </message>
    <message>
      <source>Correct the template, or use the built-in one.</source>
      <translation>请更正模板，或使用内置模板。</translation>
    </message>
    <message>
      <source>Correct this entry of the template.</source>
      <translation>请更正模板的此条目。</translation>
    </message>
    <message>
      <source>Cross-sections</source>
      <translation>截面</translation>
    </message>
    <message>
      <source>Designator</source>
      <translation>特性标识</translation>
    </message>
    <message>
      <source>Deviation from the nominal in colours</source>
      <translation>以颜色表示的与名义模型的偏差</translation>
    </message>
    <message>
      <source>Deviation on the nominal, {v1}</source>
      <translation>名义表面上的偏差，{v1}</translation>
    </message>
    <message>
      <source>Deviations by {name}</source>
      <translation>按{name}归类的偏差</translation>
    </message>
    <message>
      <source>Dimensions that do not pass</source>
      <translation>未合格的尺寸</translation>
    </message>
    <message>
      <source>Dimensions, the worst first</source>
      <translation>尺寸，最差者在前</translation>
    </message>
    <message>
      <source>Drag to turn, wheel to zoom, Shift and drag to move, double-click to reset. Click a dimension to see its place.</source>
      <translation>拖动旋转，滚轮缩放，按住 Shift 拖动平移，双击复位。单击尺寸可查看其位置。</translation>
    </message>
    <message>
      <source>Each part counts once, with its last measurement. Values measured with another nominal or other limits are left out. Below each chart: moving ranges.</source>
      <translation>每个工件只计一次，取其最后一次测量。以其他名义值或其他极限测得的值不计入。各图下方：移动极差。</translation>
    </message>
    <message>
      <source>Effect of error motions</source>
      <translation>误差运动的影响</translation>
    </message>
    <message>
      <source>Error motions</source>
      <translation>误差运动</translation>
    </message>
    <message>
      <source>Evaluated by another version of MeasureApp than the rest: {v1}. Their U may follow another error model.</source>
      <translation>由与其余不同的 MeasureApp 版本评定：{v1}。其 U 依据的误差模型可能不同。</translation>
    </message>
    <message>
      <source>Exposure rule</source>
      <translation>曝光规则</translation>
    </message>
    <message>
      <source>Exposures (µs)</source>
      <translation>曝光 (µs)</translation>
    </message>
    <message>
      <source>Exposures ms</source>
      <translation>曝光 ms</translation>
    </message>
    <message>
      <source>Filled, too far</source>
      <translation>已填补、过远</translation>
    </message>
    <message>
      <source>First run</source>
      <translation>首次测量</translation>
    </message>
    <message>
      <source>Flange in base x, y, z mm</source>
      <translation>法兰在基座系中 x, y, z mm</translation>
    </message>
    <message>
      <source>Further dimensions</source>
      <translation>其他尺寸</translation>
    </message>
    <message>
      <source>Give a PNG, JPEG or SVG file of at most 5 MB.</source>
      <translation>请给出最大 5 MB 的 PNG、JPEG 或 SVG 文件。</translation>
    </message>
    <message>
      <source>Give a folder with a template.toml, or a Typst file.</source>
      <translation>请给出含 template.toml 的文件夹，或 Typst 文件。</translation>
    </message>
    <message>
      <source>Guide mm</source>
      <translation>导轨 mm</translation>
    </message>
    <message>
      <source>Head temperature during calibration</source>
      <translation>标定时的测头温度</translation>
    </message>
    <message>
      <source>Head temperature during scan</source>
      <translation>扫描时的测头温度</translation>
    </message>
    <message>
      <source>Height of a step</source>
      <translation>台阶高度</translation>
    </message>
    <message>
      <source>In tolerance</source>
      <translation>公差带内位置</translation>
    </message>
    <message>
      <source>Interval of s</source>
      <translation>s 的区间</translation>
    </message>
    <message>
      <source>Last run</source>
      <translation>末次测量</translation>
    </message>
    <message>
      <source>Length reference</source>
      <translation>长度基准</translation>
    </message>
    <message>
      <source>Lengths in mm. The bar shows the deviation between lower and upper limit, with ± U; a square lies beyond the bar’s end.</source>
      <translation>长度单位为 mm。条形图显示偏差在下极限与上极限之间的位置，并带 ± U；方块表示超出条形图末端。</translation>
    </message>
    <message>
      <source>Letters</source>
      <translation>字母</translation>
    </message>
    <message>
      <source>Limits</source>
      <translation>极限</translation>
    </message>
    <message>
      <source>Limits of the drift check</source>
      <translation>漂移检查的限度</translation>
    </message>
    <message>
      <source>Loop closure</source>
      <translation>闭环</translation>
    </message>
    <message>
      <source>Marks of the board</source>
      <translation>标定板的标记</translation>
    </message>
    <message>
      <source>Maximum (behind)</source>
      <translation>最大值（背面）</translation>
    </message>
    <message>
      <source>Maximum at</source>
      <translation>最大值位置</translation>
    </message>
    <message>
      <source>Maximum, confirmed</source>
      <translation>确认的最大值</translation>
    </message>
    <message>
      <source>Mean moving range</source>
      <translation>平均移动极差</translation>
    </message>
    <message>
      <source>Mean ±</source>
      <translation>平均值 ±</translation>
    </message>
    <message>
      <source>Measured at</source>
      <translation>测量时间</translation>
    </message>
    <message>
      <source>Measured points, {v1}</source>
      <translation>测得的点，{v1}</translation>
    </message>
    <message>
      <source>Measured surface (dark: filled, not measured), {v1}</source>
      <translation>测量的表面（深色：已填补，未测量），{v1}</translation>
    </message>
    <message>
      <source>Measured surface, rotatable</source>
      <translation>测量的表面，可旋转</translation>
    </message>
    <message>
      <source>Measured surface, {v1}</source>
      <translation>测量的表面，{v1}</translation>
    </message>
    <message>
      <source>Measured: name, date, signature</source>
      <translation>测量：姓名、日期、签名</translation>
    </message>
    <message>
      <source>Merge voxel (mm)</source>
      <translation>合并体素 (mm)</translation>
    </message>
    <message>
      <source>Minimum (behind)</source>
      <translation>最小值（背面）</translation>
    </message>
    <message>
      <source>Minimum at</source>
      <translation>最小值位置</translation>
    </message>
    <message>
      <source>Minimum, confirmed</source>
      <translation>确认的最小值</translation>
    </message>
    <message>
      <source>NO VERDICT</source>
      <translation>不作判定</translation>
    </message>
    <message>
      <source>No deviation from the nominal</source>
      <translation>没有与名义模型的偏差</translation>
    </message>
    <message>
      <source>No dimension has a tolerance: no verdict.</source>
      <translation>没有尺寸带公差：不作判定。</translation>
    </message>
    <message>
      <source>No inspection program: no dimensions evaluated.</source>
      <translation>没有检测程序：未评定尺寸。</translation>
    </message>
    <message>
      <source>No spread: no index.</source>
      <translation>没有离散：不给出指数。</translation>
    </message>
    <message>
      <source>No tolerance: no index.</source>
      <translation>没有公差：不给出指数。</translation>
    </message>
    <message>
      <source>No.</source>
      <translation>序号</translation>
    </message>
    <message>
      <source>No. {number} · nominal {nominal}, tolerance</source>
      <translation>序号 {number} · 名义值 {nominal}，公差</translation>
    </message>
    <message>
      <source>Noise mm</source>
      <translation>噪声 mm</translation>
    </message>
    <message>
      <source>Nominal not seen</source>
      <translation>名义未看到</translation>
    </message>
    <message>
      <source>Not determined by the points</source>
      <translation>点未能确定的运动</translation>
    </message>
    <message>
      <source>Number of runs</source>
      <translation>测量次数</translation>
    </message>
    <message>
      <source>Of 1 dimension: {v1}.</source>
      <translation>1 个尺寸：{v1}。</translation>
    </message>
    <message>
      <source>Of all points</source>
      <translation>全部点</translation>
    </message>
    <message>
      <source>Of {v1} dimensions: {v2}.</source>
      <translation>{v1} 个尺寸中：{v2}。</translation>
    </message>
    <message>
      <source>Page {page} of {pages}</source>
      <translation>第 {page} 页，共 {pages} 页</translation>
    </message>
    <message>
      <source>Parts with a value</source>
      <translation>有测得值的工件</translation>
    </message>
    <message>
      <source>Pitch of blades</source>
      <translation>叶片节距</translation>
    </message>
    <message>
      <source>Points within the scale</source>
      <translation>色标范围内的点</translation>
    </message>
    <message>
      <source>Points within {limits}</source>
      <translation>{limits} 内的点</translation>
    </message>
    <message>
      <source>Points, filter and criterion</source>
      <translation>点、滤波与准则</translation>
    </message>
    <message>
      <source>Positions as read back from the axes; exposures of the stored images.</source>
      <translation>位置为各轴的回读值；曝光为所存图像的曝光。</translation>
    </message>
    <message>
      <source>Preliminary: {v1} parts.</source>
      <translation>初步：{v1} 个工件。</translation>
    </message>
    <message>
      <source>RMS</source>
      <translation>均方根</translation>
    </message>
    <message>
      <source>Reason for repeating</source>
      <translation>重测原因</translation>
    </message>
    <message>
      <source>Released</source>
      <translation>批准</translation>
    </message>
    <message>
      <source>Released: name, date, signature</source>
      <translation>批准：姓名、日期、签名</translation>
    </message>
    <message>
      <source>Residual mm</source>
      <translation>残差 mm</translation>
    </message>
    <message>
      <source>Residual of the alignment</source>
      <translation>对齐的残差</translation>
    </message>
    <message>
      <source>Residuals of the alignment</source>
      <translation>对齐的残差</translation>
    </message>
    <message>
      <source>Rig calibrated</source>
      <translation>测量系统标定</translation>
    </message>
    <message>
      <source>Rotation axis</source>
      <translation>旋转轴</translation>
    </message>
    <message>
      <source>Rotation °</source>
      <translation>旋转 °</translation>
    </message>
    <message>
      <source>Runs</source>
      <translation>各次测量</translation>
    </message>
    <message>
      <source>Section at {v1} = {v2} mm: nominal in black, deviation enlarged {v3} times</source>
      <translation>{v1} = {v2} mm 处的截面：黑色为名义轮廓，偏差放大 {v3} 倍</translation>
    </message>
    <message>
      <source>Share of calibration and length scale in U</source>
      <translation>标定与长度比例在 U 中的份额</translation>
    </message>
    <message>
      <source>Shift and rotation: correction of the kinematic position by registration. Residual: rms distance from neighbouring views after registration.</source>
      <translation>平移与旋转：配准对运动学位置的修正。残差：配准后与相邻视图的均方根距离。</translation>
    </message>
    <message>
      <source>Shift mm</source>
      <translation>平移 mm</translation>
    </message>
    <message>
      <source>Spacing (mm)</source>
      <translation>点间距 (mm)</translation>
    </message>
    <message>
      <source>Std. dev. s</source>
      <translation>标准差 s</translation>
    </message>
    <message>
      <source>Stitched points</source>
      <translation>拼接后的点数</translation>
    </message>
    <message>
      <source>Summary</source>
      <translation>摘要</translation>
    </message>
    <message>
      <source>Table °</source>
      <translation>转台 °</translation>
    </message>
    <message>
      <source>Temperature of the part</source>
      <translation>工件温度</translation>
    </message>
    <message>
      <source>The alignment is a best fit, which belongs to no datum system and spreads defects over the whole part: for comparison only.</source>
      <translation>对齐采用最佳拟合，它不属于任何基准体系，并会把缺陷分摊到整个工件上：仅供比较。</translation>
    </message>
    <message>
      <source>The series of {v1} has no runs.</source>
      <translation>{v1} 的系列没有测量。</translation>
    </message>
    <message>
      <source>The {count} earlier runs are in the CSV and JSON files.</source>
      <translation>更早的 {count} 次测量见 CSV 和 JSON 文件。</translation>
    </message>
    <message>
      <source>This part was measured without an inspection program: the report contains views and cloud, but no dimensions.</source>
      <translation>此工件未用检测程序测量：报告包含视图和点云，但不含尺寸。</translation>
    </message>
    <message>
      <source>Traceability and uncertainty budget</source>
      <translation>溯源与不确定度预算</translation>
    </message>
    <message>
      <source>U (k = 2)</source>
      <translation>U (k = 2)</translation>
    </message>
    <message>
      <source>U of one value (k = 2)</source>
      <translation>单个值的 U (k = 2)</translation>
    </message>
    <message>
      <source>Valid pixels of the exposures</source>
      <translation>各曝光的有效像素</translation>
    </message>
    <message>
      <source>Valid: above zero and unsaturated in all images of the exposure; composite: of the longest exposure in which the pixel is unsaturated; decoded: with a phase. Means over the viewpoints.</source>
      <translation>有效：在该曝光的所有图像中大于零且未饱和；合成：取像素未饱和的最长曝光；已解码：有相位。各视点的平均值。</translation>
    </message>
    <message>
      <source>Viewpoints as measured</source>
      <translation>实测视点</translation>
    </message>
    <message>
      <source>Warning.</source>
      <translation>警告：</translation>
    </message>
    <message>
      <source>Worst {count} of {total} dimensions</source>
      <translation>{total} 个尺寸中最差的 {count} 个</translation>
    </message>
    <message>
      <source>Written</source>
      <translation>生成时间</translation>
    </message>
    <message>
      <source>Written {time}</source>
      <translation>生成于 {time}</translation>
    </message>
    <message>
      <source>Zone</source>
      <translation>图区</translation>
    </message>
    <message>
      <source>aligned by {name}</source>
      <translation>按{name}对齐</translation>
    </message>
    <message>
      <source>at most {v1} mm ({v2})</source>
      <translation>最多 {v1} mm（{v2}）</translation>
    </message>
    <message>
      <source>blur {v1} px</source>
      <translation>模糊 {v1} px</translation>
    </message>
    <message>
      <source>calibration board; uncertainty of its lengths and of the part temperature {v1}</source>
      <translation>标定板；其长度及工件温度的不确定度{v1}</translation>
    </message>
    <message>
      <source>contradicts U</source>
      <translation>与 U 矛盾</translation>
    </message>
    <message>
      <source>defines the part frame</source>
      <translation>定义工件坐标系</translation>
    </message>
    <message>
      <source>deviation {v1}</source>
      <translation>偏差 {v1}</translation>
    </message>
    <message>
      <source>displaced by {v1} mm (rms), estimated with the cameras</source>
      <translation>位移 {v1} mm（均方根），与相机一并估计</translation>
    </message>
    <message>
      <source>exposure rule</source>
      <translation>曝光规则</translation>
    </message>
    <message>
      <source>exposure {v1}</source>
      <translation>曝光 {v1}</translation>
    </message>
    <message>
      <source>from the opposite side, below</source>
      <translation>从对侧下方</translation>
    </message>
    <message>
      <source>guide: {v1}</source>
      <translation>导轨：{v1}</translation>
    </message>
    <message>
      <source>in the contribution "scale"</source>
      <translation>计入“比例”分量</translation>
    </message>
    <message>
      <source>joined by common surface</source>
      <translation>按公共表面合并</translation>
    </message>
    <message>
      <source>joined by common surface and nominal</source>
      <translation>按公共表面和名义模型合并</translation>
    </message>
    <message>
      <source>joined by reference spheres</source>
      <translation>按参考球合并</translation>
    </message>
    <message>
      <source>mean moving range of two parts / 1.128</source>
      <translation>相邻两工件的平均移动极差 / 1.128</translation>
    </message>
    <message>
      <source>measured {time}, rig calibrated {calibrated}</source>
      <translation>测量于 {time}，测量系统标定于 {calibrated}</translation>
    </message>
    <message>
      <source>no value</source>
      <translation>无值</translation>
    </message>
    <message>
      <source>not as planned</source>
      <translation>与计划不同</translation>
    </message>
    <message>
      <source>not included (taken as exact)</source>
      <translation>未计入（视为精确）</translation>
    </message>
    <message>
      <source>not reported by the rig</source>
      <translation>测量系统未报告</translation>
    </message>
    <message>
      <source>not stitched</source>
      <translation>未拼接</translation>
    </message>
    <message>
      <source>oblique view</source>
      <translation>斜视图</translation>
    </message>
    <message>
      <source>over {v1} views around the part: {v2}</source>
      <translation>绕工件 {v1} 个视图：{v2}</translation>
    </message>
    <message>
      <source>rms {v1} px</source>
      <translation>均方根 {v1} px</translation>
    </message>
    <message>
      <source>scale {v1} ± {v2}, σ {v3}°, straightness {v4} mm</source>
      <translation>比例 {v1} ± {v2}，σ {v3}°，直线度 {v4} mm</translation>
    </message>
    <message>
      <source>serial {v1}</source>
      <translation>序列号 {v1}</translation>
    </message>
    <message>
      <source>standard deviation of all parts</source>
      <translation>所有工件的标准差</translation>
    </message>
    <message>
      <source>table: {v1}</source>
      <translation>转台：{v1}</translation>
    </message>
    <message>
      <source>template {name}, version {version}</source>
      <translation>模板：{name}，版本 {version}</translation>
    </message>
    <message>
      <source>the template</source>
      <translation>模板</translation>
    </message>
    <message>
      <source>top view</source>
      <translation>俯视图</translation>
    </message>
    <message>
      <source>within U</source>
      <translation>在 U 之内</translation>
    </message>
    <message>
      <source>written {time}</source>
      <translation>生成于 {time}</translation>
    </message>
    <message>
      <source>{count} no tolerance</source>
      <translation>{count} 个无公差</translation>
    </message>
    <message>
      <source>{role}: name, date, signature</source>
      <translation>{role}：姓名、日期、签名</translation>
    </message>
    <message>
      <source>{v1} (an earlier one)</source>
      <translation>{v1}（更早的版本）</translation>
    </message>
    <message>
      <source>{v1} (hidden in this view)</source>
      <translation>{v1}（在此视图中被遮挡）</translation>
    </message>
    <message>
      <source>{v1} Normal distribution not tested. The spread includes that of the measurement.</source>
      <translation>{v1} 未检验正态分布。离散包含测量的离散。</translation>
    </message>
    <message>
      <source>{v1} before</source>
      <translation>测量前 {v1}</translation>
    </message>
    <message>
      <source>{v1} before (see the warning)</source>
      <translation>测量前 {v1}（见警告）</translation>
    </message>
    <message>
      <source>{v1} days</source>
      <translation>{v1} 天</translation>
    </message>
    <message>
      <source>{v1} does not exist.</source>
      <translation>{v1} 不存在。</translation>
    </message>
    <message>
      <source>{v1} is not a logo that a report can show.</source>
      <translation>{v1} 不是报告能显示的徽标。</translation>
    </message>
    <message>
      <source>{v1} min</source>
      <translation>{v1} 分钟</translation>
    </message>
    <message>
      <source>{v1} mm and {v2}° (expected: {v3} mm)</source>
      <translation>{v1} mm 和 {v2}°（预期：{v3} mm）</translation>
    </message>
    <message>
      <source>{v1} mm rms over {v2} of the points</source>
      <translation>{v1} mm 均方根，占点的 {v2}</translation>
    </message>
    <message>
      <source>{v1} of {v2} used</source>
      <translation>使用 {v1} 个，共 {v2} 个</translation>
    </message>
    <message>
      <source>{v1} parts.</source>
      <translation>{v1} 个工件。</translation>
    </message>
    <message>
      <source>{v1} parts: no index below {v2}.</source>
      <translation>{v1} 个工件：少于 {v2} 个不给出指数。</translation>
    </message>
    <message>
      <source>{v1} triangles</source>
      <translation>{v1} 个三角形</translation>
    </message>
    <message>
      <source>{v1} triangles, {v2} filled</source>
      <translation>{v1} 个三角形，{v2} 为填补</translation>
    </message>
    <message>
      <source>{v1}, {v2} common; joint σ {v3} mm and {v4}°, residual {v5} mm</source>
      <translation>{v1}，{v2} 公共；连接 σ {v3} mm 和 {v4}°，残差 {v5} mm</translation>
    </message>
    <message>
      <source>{v1}: the report template has an error: {v2}.</source>
      <translation>{v1}：报告模板有错误：{v2}。</translation>
    </message>
    <message>
      <source>{v1}; composite {v2}; decoded {v3} (least {v4}, {v5})</source>
      <translation>{v1}；合成 {v2}；已解码 {v3}（最少 {v4}，{v5}）</translation>
    </message>
    <message>
      <source>± and interval: confidence intervals from the spread alone (Student’s t, chi-square). p: probability of this spread or a larger one if the stated uncertainty U is right. Systematic errors cause no spread.</source>
      <translation>± 和区间：仅由离散得出的置信区间（学生 t 分布、卡方分布）。p：若给定的不确定度 U 正确，出现此离散或更大离散的概率。系统误差不产生离散。</translation>
    </message>
    <message>
      <source>σ {v1} mm and {v2}°, residual {v3} mm</source>
      <translation>σ {v1} mm 和 {v2}°，残差 {v3} mm</translation>
    </message>
    <message>
      <source>σ {v1} mm and {v2}°, residual {v3} mm ({v4})</source>
      <translation>σ {v1} mm 和 {v2}°，残差 {v3} mm（{v4}）</translation>
    </message>
  </context>
  <context>
    <name>core.resources</name>
    <message>
      <source>Check the name; if it is correct, the installation is incomplete: install again.</source>
      <translation>请检查名称；若正确，则安装不完整：请重新安装。</translation>
    </message>
    <message>
      <source>The program has no file {v1}.</source>
      <translation>程序没有文件 {v1}。</translation>
    </message>
  </context>
  <context>
    <name>core.robot_abb</name>
    <message>
      <source> Its program was started again by somebody else.</source>
      <translation>其程序被他人重新启动。</translation>
    </message>
    <message>
      <source> The controller reports: {v1}.</source>
      <translation>控制器报告：{v1}。</translation>
    </message>
    <message>
      <source>A message of the pose stream is invalid ({v1}): {v2}.</source>
      <translation>位姿流的消息无效 ({v1})：{v2}。</translation>
    </message>
    <message>
      <source>Allow more time for the move.</source>
      <translation>请为移动给出更多时间。</translation>
    </message>
    <message>
      <source>Bring the controller into the state named, then connect again.</source>
      <translation>请使控制器进入所述状态，然后重新连接。</translation>
    </message>
    <message>
      <source>Check for a collision or a protective stop, then connect again.</source>
      <translation>请检查是否发生碰撞或保护性停止，然后重新连接。</translation>
    </message>
    <message>
      <source>Check on the FlexPendant that its main is the one of MeasureApp.mod.</source>
      <translation>请在 FlexPendant 上检查其 main 是否为 MeasureApp.mod 中的 main。</translation>
    </message>
    <message>
      <source>Check that EGMStreamStart runs in the controller and that its UDP unicast device names this computer and port.</source>
      <translation>请检查控制器中 EGMStreamStart 是否在运行，其 UDP 单播设备是否指向这台计算机和端口。</translation>
    </message>
    <message>
      <source>Check that it is on and its network cable is plugged in, then connect again. The robot's state is unknown.</source>
      <translation>请检查其是否已开机、网线是否已插好，然后重新连接。机器人的状态未知。</translation>
    </message>
    <message>
      <source>Check that the address is that of the robot's controller, and the version of Robot Web Services.</source>
      <translation>请检查地址是否为机器人控制器的地址，以及 Robot Web Services 的版本。</translation>
    </message>
    <message>
      <source>Check that the robot alone sends to this port.</source>
      <translation>请检查只有机器人向此端口发送。</translation>
    </message>
    <message>
      <source>Check the address, or correct system_id in the robot's settings.</source>
      <translation>请检查地址，或更正机器人设置中的 system_id。</translation>
    </message>
    <message>
      <source>Check the kinematic model in the robot's settings, tool0 and the base frame; if the robot is moving, wait.</source>
      <translation>请检查机器人设置中的运动学模型、tool0 和基坐标系；若机器人在运动，请等待。</translation>
    </message>
    <message>
      <source>Check the load and the brakes.</source>
      <translation>请检查负载和制动器。</translation>
    </message>
    <message>
      <source>Check the mechanical unit and task in the settings.</source>
      <translation>请检查设置中的机械单元和任务。</translation>
    </message>
    <message>
      <source>Check the speed set on the FlexPendant and that nothing is in the robot's way.</source>
      <translation>请检查 FlexPendant 上设定的速度，以及机器人路径上有无障碍。</translation>
    </message>
    <message>
      <source>Check the version of Robot Web Services.</source>
      <translation>请检查 Robot Web Services 的版本。</translation>
    </message>
    <message>
      <source>Check what has changed, then connect again.</source>
      <translation>请检查有何变化，然后重新连接。</translation>
    </message>
    <message>
      <source>Choose a free port in settings and controller.</source>
      <translation>请在设置和控制器中选择空闲端口。</translation>
    </message>
    <message>
      <source>Choose the model of this arm in the robot's settings; check tool0 and the base frame in the controller.</source>
      <translation>请在机器人设置中选择此手臂的型号；检查控制器中的 tool0 和基坐标系。</translation>
    </message>
    <message>
      <source>Close other programs that are connected to the controller, wait 5 minutes, then connect again.</source>
      <translation>请关闭连接到该控制器的其他程序，等待 5 分钟，然后重新连接。</translation>
    </message>
    <message>
      <source>Close that program. If it has ended without releasing the robot, switch on take_over in the robot's settings.</source>
      <translation>请关闭该程序。若它已结束而未释放机器人，请在机器人设置中打开 take_over。</translation>
    </message>
    <message>
      <source>Close the guard and acknowledge it, then switch the motors on.</source>
      <translation>请关闭防护门并确认，然后接通电机。</translation>
    </message>
    <message>
      <source>Confirm automatic mode on the FlexPendant, then connect again.</source>
      <translation>请在 FlexPendant 上确认自动模式，然后重新连接。</translation>
    </message>
    <message>
      <source>Connect again.</source>
      <translation>请重新连接。</translation>
    </message>
    <message>
      <source>Correct user and password, or the version of Robot Web Services, in the robot's settings.</source>
      <translation>请更正机器人设置中的用户和密码，或 Robot Web Services 的版本。</translation>
    </message>
    <message>
      <source>Enter the fingerprint of the controller's certificate in the robot's settings, after comparing it at the controller.</source>
      <translation>请在控制器处核对后，将其证书的指纹输入机器人设置。</translation>
    </message>
    <message>
      <source>Find the cause, check that nothing is in the robot's way, then connect again.</source>
      <translation>请查明原因，确认机器人路径上没有障碍，然后重新连接。</translation>
    </message>
    <message>
      <source>Load resources/rapid/MeasureApp.mod of this program into the task, and connect again.</source>
      <translation>请将本程序的 resources/rapid/MeasureApp.mod 载入任务，然后重新连接。</translation>
    </message>
    <message>
      <source>MM 1.0</source>
      <translation>MM 1.0</translation>
    </message>
    <message>
      <source>Mastership of RAPID is held by {v1}.</source>
      <translation>RAPID 的控制权由 {v1} 持有。</translation>
    </message>
    <message>
      <source>Press the emergency stop.</source>
      <translation>请按下急停按钮。</translation>
    </message>
    <message>
      <source>Press the motors-on button, then connect again.</source>
      <translation>请按下电机上电按钮，然后重新连接。</translation>
    </message>
    <message>
      <source>Read the event log on the FlexPendant and restart the controller.</source>
      <translation>请查看 FlexPendant 上的事件日志，并重启控制器。</translation>
    </message>
    <message>
      <source>Read the event log on the FlexPendant, then connect again.</source>
      <translation>请查看 FlexPendant 上的事件日志，然后重新连接。</translation>
    </message>
    <message>
      <source>Read the event log on the FlexPendant.</source>
      <translation>请查看 FlexPendant 上的事件日志。</translation>
    </message>
    <message>
      <source>Remove the cause, release the emergency stop, press the motors-on button, then connect again.</source>
      <translation>请排除原因，松开急停，按下电机上电按钮，然后重新连接。</translation>
    </message>
    <message>
      <source>Select automatic mode.</source>
      <translation>请选择自动模式。</translation>
    </message>
    <message>
      <source>Set mm_cmd to 0 on the FlexPendant while the program is stopped.</source>
      <translation>请在程序停止时于 FlexPendant 上将 mm_cmd 设为 0。</translation>
    </message>
    <message>
      <source>Switch the motors on.</source>
      <translation>请接通电机。</translation>
    </message>
    <message>
      <source>The connection to the controller at {v1} was closed.</source>
      <translation>与 {v1} 处控制器的连接已关闭。</translation>
    </message>
    <message>
      <source>The controller at {v1} did not answer to {v2}.</source>
      <translation>{v1} 处的控制器没有应答 {v2}。</translation>
    </message>
    <message>
      <source>The controller at {v1} does not answer any more ({v2}).</source>
      <translation>{v1} 处的控制器不再应答（{v2}）。</translation>
    </message>
    <message>
      <source>The controller at {v1} is system {v2}; the settings expect {v3}.</source>
      <translation>{v1} 处的控制器是系统 {v2}；设置期望 {v3}。</translation>
    </message>
    <message>
      <source>The controller at {v1} refuses user {v2} (401).</source>
      <translation>{v1} 处的控制器拒绝用户 {v2} (401)。</translation>
    </message>
    <message>
      <source>The controller did not carry out {v1}: it reads back something else.</source>
      <translation>控制器没有执行 {v1}：读回的不同。</translation>
    </message>
    <message>
      <source>The controller has no module of this program: {v1}</source>
      <translation>控制器没有此程序的模块：{v1}</translation>
    </message>
    <message>
      <source>The controller has no session left (503); it allows about 70 at a time, and one that is not logged out lasts 5 minutes.</source>
      <translation>控制器没有空余会话 (503)；它一次约允许 70 个，未注销的会话保持 5 分钟。</translation>
    </message>
    <message>
      <source>The controller refused {v1} ({v2}, code {v3}){v4}.</source>
      <translation>控制器拒绝了 {v1}（{v2}，代码 {v3}）{v4}。</translation>
    </message>
    <message>
      <source>The controller's answer to {v1} has no {v2}.</source>
      <translation>控制器对 {v1} 的应答没有 {v2}。</translation>
    </message>
    <message>
      <source>The controller's answer to {v1} has {v2} in place of a number.</source>
      <translation>控制器对 {v1} 的应答以 {v2} 代替数字。</translation>
    </message>
    <message>
      <source>The controller's answer to {v1} is empty.</source>
      <translation>控制器对 {v1} 的应答为空。</translation>
    </message>
    <message>
      <source>The controller's answer to {v1} is invalid ({v2}): {v3}.</source>
      <translation>控制器对 {v1} 的应答无效 ({v2})：{v3}。</translation>
    </message>
    <message>
      <source>The controller's certificate is not accepted: {v1}.</source>
      <translation>控制器的证书不被接受：{v1}。</translation>
    </message>
    <message>
      <source>The controller's module is another one: {v1}.</source>
      <translation>控制器的模块是另一个：{v1}。</translation>
    </message>
    <message>
      <source>The controller's module is version {v1} ({v2}); this program needs {v3} ({v4}).</source>
      <translation>控制器的模块版本为 {v1} ({v2})；此程序需要 {v3} ({v4})。</translation>
    </message>
    <message>
      <source>The controller's pose has a quaternion of length {v1}.</source>
      <translation>控制器的位姿有长度为 {v1} 的四元数。</translation>
    </message>
    <message>
      <source>The counter of orders is used up.</source>
      <translation>指令计数器已用尽。</translation>
    </message>
    <message>
      <source>The program in the controller {v1}.</source>
      <translation>控制器中的程序{v1}。</translation>
    </message>
    <message>
      <source>The robot is used by another program (computer {v1}, process {v2}); this one may only read.</source>
      <translation>机器人正由另一程序使用（计算机 {v1}，进程 {v2}）；此程序只能读取。</translation>
    </message>
    <message>
      <source>The robot may not move: {v1}.</source>
      <translation>机器人不允许移动：{v1}。</translation>
    </message>
    <message>
      <source>The robot's controller confirms no stop.</source>
      <translation>机器人控制器未确认停止。</translation>
    </message>
    <message>
      <source>The robot's pose stream on UDP port {v1} {v2}.</source>
      <translation>UDP 端口 {v1} 上的机器人位姿流{v2}。</translation>
    </message>
    <message>
      <source>Turn the key to automatic mode, confirm it on the FlexPendant, then connect again.</source>
      <translation>请将钥匙转到自动模式，在 FlexPendant 上确认，然后重新连接。</translation>
    </message>
    <message>
      <source>Turn the key to automatic mode, then connect again.</source>
      <translation>请将钥匙转到自动模式，然后重新连接。</translation>
    </message>
    <message>
      <source>UDP port {v1} for the pose stream cannot be opened: {v2}.</source>
      <translation>无法打开位姿流的 UDP 端口 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>Wait until the controller has started.</source>
      <translation>请等待控制器启动完成。</translation>
    </message>
    <message>
      <source>Wait until the move has ended.</source>
      <translation>请等待移动结束。</translation>
    </message>
    <message>
      <source>a number is not finite</source>
      <translation>某个数不是有限数</translation>
    </message>
    <message>
      <source>a number of more than 64 bits</source>
      <translation>超过 64 位的数</translation>
    </message>
    <message>
      <source>a part is missing</source>
      <translation>缺少一部分</translation>
    </message>
    <message>
      <source>address: Robot Web Services 1.0 use http</source>
      <translation>address：Robot Web Services 1.0 使用 http</translation>
    </message>
    <message>
      <source>address: Robot Web Services 2.0 use https, except on this computer</source>
      <translation>address：Robot Web Services 2.0 使用 https，本机除外</translation>
    </message>
    <message>
      <source>an answer of more than {v1} bytes</source>
      <translation>超过 {v1} 字节的应答</translation>
    </message>
    <message>
      <source>another client</source>
      <translation>另一客户端</translation>
    </message>
    <message>
      <source>automatic mode</source>
      <translation>自动模式</translation>
    </message>
    <message>
      <source>changing to automatic mode</source>
      <translation>正在切换到自动模式</translation>
    </message>
    <message>
      <source>changing to manual mode</source>
      <translation>正在切换到手动模式</translation>
    </message>
    <message>
      <source>cut off</source>
      <translation>被截断</translation>
    </message>
    <message>
      <source>emergency stop</source>
      <translation>急停</translation>
    </message>
    <message>
      <source>emergency stop released, motors off</source>
      <translation>急停已松开，电机断电</translation>
    </message>
    <message>
      <source>failed with error {v1}</source>
      <translation>出错，错误号 {v1}</translation>
    </message>
    <message>
      <source>has no heartbeat (state {v1}, error {v2})</source>
      <translation>没有心跳（状态 {v1}，错误 {v2}）</translation>
    </message>
    <message>
      <source>has not begun</source>
      <translation>尚未开始</translation>
    </message>
    <message>
      <source>is stale: message {v1} is {v2} s old</source>
      <translation>已过期：报文 {v1} 为 {v2} s 之前</translation>
    </message>
    <message>
      <source>manual mode with full speed</source>
      <translation>全速手动模式</translation>
    </message>
    <message>
      <source>manual mode with reduced speed</source>
      <translation>减速手动模式</translation>
    </message>
    <message>
      <source>mastership of RAPID</source>
      <translation>RAPID 的控制权</translation>
    </message>
    <message>
      <source>mm_answer of the controller has {v1} numbers instead of 5: {v2}.</source>
      <translation>控制器的 mm_answer 有 {v1} 个数字而非 5 个：{v2}。</translation>
    </message>
    <message>
      <source>mm_answer of the controller is invalid: {v1}.</source>
      <translation>控制器的 mm_answer 无效：{v1}。</translation>
    </message>
    <message>
      <source>mm_cmd of the controller is invalid: {v1}.</source>
      <translation>控制器的 mm_cmd 无效：{v1}。</translation>
    </message>
    <message>
      <source>mm_owner of the controller is invalid: {v1}.</source>
      <translation>控制器的 mm_owner 无效：{v1}。</translation>
    </message>
    <message>
      <source>mode {v1}</source>
      <translation>模式 {v1}</translation>
    </message>
    <message>
      <source>motors off</source>
      <translation>电机断电</translation>
    </message>
    <message>
      <source>motors on</source>
      <translation>电机上电</translation>
    </message>
    <message>
      <source>motors {v1}</source>
      <translation>电机 {v1}</translation>
    </message>
    <message>
      <source>no HTTP: {v1}</source>
      <translation>不是 HTTP：{v1}</translation>
    </message>
    <message>
      <source>no JSON object</source>
      <translation>不是 JSON 对象</translation>
    </message>
    <message>
      <source>no counter</source>
      <translation>没有计数器</translation>
    </message>
    <message>
      <source>no list of states</source>
      <translation>没有状态列表</translation>
    </message>
    <message>
      <source>off</source>
      <translation>关</translation>
    </message>
    <message>
      <source>on</source>
      <translation>开</translation>
    </message>
    <message>
      <source>protective stop: a guard is open</source>
      <translation>保护性停止：防护门打开</translation>
    </message>
    <message>
      <source>refused the order</source>
      <translation>拒绝了指令</translation>
    </message>
    <message>
      <source>release mastership</source>
      <translation>释放控制权</translation>
    </message>
    <message>
      <source>request mastership</source>
      <translation>请求控制权</translation>
    </message>
    <message>
      <source>running</source>
      <translation>正在运行</translation>
    </message>
    <message>
      <source>set ctrlstate</source>
      <translation>设置 ctrlstate</translation>
    </message>
    <message>
      <source>set symbol</source>
      <translation>设置符号</translation>
    </message>
    <message>
      <source>state {v1}</source>
      <translation>状态 {v1}</translation>
    </message>
    <message>
      <source>stopped</source>
      <translation>已停止</translation>
    </message>
    <message>
      <source>system failure</source>
      <translation>系统故障</translation>
    </message>
    <message>
      <source>system {v1}, RobotWare {v2}, program {v3}</source>
      <translation>系统 {v1}，RobotWare {v2}，程序 {v3}</translation>
    </message>
    <message>
      <source>the answer to {v1} is not complete</source>
      <translation>对 {v1} 的应答不完整</translation>
    </message>
    <message>
      <source>the start of the program</source>
      <translation>程序的启动</translation>
    </message>
    <message>
      <source>the stop of the program</source>
      <translation>程序的停止</translation>
    </message>
    <message>
      <source>the value {v1} of {v2}</source>
      <translation>{v2} 的值 {v1}</translation>
    </message>
    <message>
      <source>type {v1}</source>
      <translation>类型 {v1}</translation>
    </message>
    <message>
      <source>was not started</source>
      <translation>没有启动</translation>
    </message>
    <message>
      <source>wire type {v1}</source>
      <translation>线格式类型 {v1}</translation>
    </message>
    <message>
      <source>{v1} ({v2}, user {v3})</source>
      <translation>{v1}（{v2}，用户 {v3}）</translation>
    </message>
    <message>
      <source>{v1} came to rest away from its goal: joint {v2} at {v3}° instead of {v4}°.</source>
      <translation>{v1} 停止时偏离目标：关节 {v2} 在 {v3}°，而非 {v4}°。</translation>
    </message>
    <message>
      <source>{v1} does not come to rest at its goal.</source>
      <translation>{v1} 没有在目标处静止。</translation>
    </message>
    <message>
      <source>{v1} has no finite numbers</source>
      <translation>{v1} 没有有限数</translation>
    </message>
    <message>
      <source>{v1} has not reached its goal in time; it was stopped.</source>
      <translation>{v1} 没有及时到达目标；已将其停止。</translation>
    </message>
    <message>
      <source>{v1} instead of {v2}</source>
      <translation>{v1}，而非 {v2}</translation>
    </message>
    <message>
      <source>{v1} is moving already.</source>
      <translation>{v1} 已在移动。</translation>
    </message>
    <message>
      <source>{v1} is no record of numbers</source>
      <translation>{v1} 不是数值记录</translation>
    </message>
    <message>
      <source>{v1} is no string</source>
      <translation>{v1} 不是字符串</translation>
    </message>
    <message>
      <source>{v1} joints, {v2} coordinates, {v3} parts of a quaternion</source>
      <translation>{v1} 个关节，{v2} 个坐标，{v3} 个四元数分量</translation>
    </message>
    <message>
      <source>{v1} was not ready to move in time.</source>
      <translation>{v1} 没有及时准备好移动。</translation>
    </message>
    <message>
      <source>{v1} was stopped: {v2}.{v3}{v4} Its pose is unknown until it is read back.</source>
      <translation>{v1} 被停止：{v2}。{v3}{v4}在读回之前，其位姿未知。</translation>
    </message>
    <message>
      <source>{v1}, {v2}, program {v3}</source>
      <translation>{v1}，{v2}，程序 {v3}</translation>
    </message>
    <message>
      <source>{v1}: another controller or program answers now: {v2}</source>
      <translation>{v1}：现在应答的是另一个控制器或程序：{v2}</translation>
    </message>
    <message>
      <source>{v1}: joint {v2} at {v3}° is outside {v4}…{v5}°.</source>
      <translation>{v1}：关节 {v2} 的 {v3}° 超出 {v4}…{v5}°。</translation>
    </message>
    <message>
      <source>{v1}: the controller's pose is {v2} mm and {v3}° off the one of its joints.</source>
      <translation>{v1}：控制器的位姿与其关节角所得位姿相差 {v2} mm 和 {v3}°。</translation>
    </message>
    <message>
      <source>{v1}: the controller's pose is {v2} mm off the one of kinematic model {v3} for the same joints.</source>
      <translation>{v1}：对相同关节角，控制器的位姿与运动学模型 {v3} 相差 {v2} mm。</translation>
    </message>
    <message>
      <source>{v1}: the program in the controller hangs.</source>
      <translation>{v1}：控制器中的程序没有响应。</translation>
    </message>
    <message>
      <source>{v1}: the program in the controller {v2}.</source>
      <translation>{v1}：控制器中的程序{v2}。</translation>
    </message>
    <message>
      <source>{v1}; nothing was moved.</source>
      <translation>{v1}；未作任何移动。</translation>
    </message>
  </context>
  <context>
    <name>core.robot_generic_tcp</name>
    <message>
      <source>A reply of the robot at {v1} is invalid ({v2}): {v3}.</source>
      <translation>{v1} 处机器人的应答无效 ({v2})：{v3}。</translation>
    </message>
    <message>
      <source>Check address and port, and the robot's program against the README of the driver robot_generic_tcp.</source>
      <translation>请检查地址和端口，并对照驱动 robot_generic_tcp 的 README 检查机器人程序。</translation>
    </message>
    <message>
      <source>Check its speed and what is in its way.</source>
      <translation>请检查其速度和路径上的障碍。</translation>
    </message>
    <message>
      <source>Check that it is on, its network cable is plugged in and its server runs, then connect again. Its state is unknown.</source>
      <translation>请检查其是否已开机、网线是否已插好、其服务器是否在运行，然后重新连接。其状态未知。</translation>
    </message>
    <message>
      <source>Check the network, then connect again.</source>
      <translation>请检查网络，然后重新连接。</translation>
    </message>
    <message>
      <source>Check the robot's program against the driver's README.</source>
      <translation>请对照驱动的 README 检查机器人的程序。</translation>
    </message>
    <message>
      <source>Choose a goal inside the robot's limits; nothing was moved.</source>
      <translation>请选择机器人限位以内的目标；未作任何移动。</translation>
    </message>
    <message>
      <source>Correct the robot's program.</source>
      <translation>请更正机器人的程序。</translation>
    </message>
    <message>
      <source>Find the cause at the robot, then connect again.</source>
      <translation>请在机器人处查明原因，然后重新连接。</translation>
    </message>
    <message>
      <source>Install the fitting version of the robot's program.</source>
      <translation>请安装适合版本的机器人程序。</translation>
    </message>
    <message>
      <source>Known are {v1}.</source>
      <translation>已知有 {v1}。</translation>
    </message>
    <message>
      <source>Remove the cause at the robot, select automatic mode, then connect again.</source>
      <translation>请在机器人处排除原因，选择自动模式，然后重新连接。</translation>
    </message>
    <message>
      <source>Remove the cause at the robot, then connect again.</source>
      <translation>请在机器人处排除原因，然后重新连接。</translation>
    </message>
    <message>
      <source>Select automatic mode at the robot.</source>
      <translation>请在机器人处选择自动模式。</translation>
    </message>
    <message>
      <source>The connection to the robot at {v1} was closed.</source>
      <translation>与 {v1} 处机器人的连接已关闭。</translation>
    </message>
    <message>
      <source>The robot at {v1} did not answer to {v2}: {v3}.</source>
      <translation>{v1} 处的机器人没有应答 {v2}：{v3}。</translation>
    </message>
    <message>
      <source>The robot at {v1} does not answer any more.</source>
      <translation>{v1} 处的机器人不再应答。</translation>
    </message>
    <message>
      <source>The robot at {v1} refused {v2}: {v3}.</source>
      <translation>{v1} 处的机器人拒绝了 {v2}：{v3}。</translation>
    </message>
    <message>
      <source>The robot at {v1} speaks version {v2} of the line protocol; this program speaks {v3}.</source>
      <translation>{v1} 处的机器人使用线协议版本 {v2}；此程序使用 {v3}。</translation>
    </message>
    <message>
      <source>a line of more than {v1} bytes</source>
      <translation>超过 {v1} 字节的一行</translation>
    </message>
    <message>
      <source>no JSON</source>
      <translation>不是 JSON</translation>
    </message>
    <message>
      <source>no object with id and ok</source>
      <translation>不是含 id 和 ok 的对象</translation>
    </message>
    <message>
      <source>no reason given</source>
      <translation>没有给出原因</translation>
    </message>
    <message>
      <source>reply {v1} to request {v2}</source>
      <translation>对请求 {v2} 的应答 {v1}</translation>
    </message>
    <message>
      <source>the connection was closed</source>
      <translation>连接已关闭</translation>
    </message>
    <message>
      <source>timed out</source>
      <translation>超时</translation>
    </message>
    <message>
      <source>unknown robot</source>
      <translation>未知机器人</translation>
    </message>
    <message>
      <source>{v1} came to rest {v2} mm and {v3}° off its goal.</source>
      <translation>{v1} 停止时偏离目标 {v2} mm、{v3}°。</translation>
    </message>
    <message>
      <source>{v1} does not confirm the stop.</source>
      <translation>{v1} 未确认停止。</translation>
    </message>
    <message>
      <source>{v1} is no whole number</source>
      <translation>{v1} 不是整数</translation>
    </message>
    <message>
      <source>{v1} is not {v2} numbers</source>
      <translation>{v1} 不是 {v2} 个数</translation>
    </message>
    <message>
      <source>{v1} reports the unknown state {v2}.</source>
      <translation>{v1} 报告未知状态 {v2}。</translation>
    </message>
    <message>
      <source>{v1} stopped before it reached its goal.</source>
      <translation>{v1} 在到达目标之前停止。</translation>
    </message>
    <message>
      <source>{v1} was stopped: {v2}, {v3} mode. Its pose is unknown until it is read back.</source>
      <translation>{v1} 被停止：{v2}，{v3} 模式。在读回之前，其位姿未知。</translation>
    </message>
    <message>
      <source>{v1}, serial number {v2}</source>
      <translation>{v1}，序列号 {v2}</translation>
    </message>
    <message>
      <source>{v1}: a flange position {v2} mm from the shoulder is outside {v3}…{v4} mm.</source>
      <translation>{v1}：距肩部 {v2} mm 的法兰位置超出 {v3}…{v4} mm。</translation>
    </message>
    <message>
      <source>{v1}: it is unknown whether move {v2} was accepted; the robot was stopped.</source>
      <translation>{v1}：不知移动 {v2} 是否被接受；已将机器人停止。</translation>
    </message>
    <message>
      <source>{v1}: the quaternion read back has length {v2}.</source>
      <translation>{v1}：读回的四元数长度为 {v2}。</translation>
    </message>
  </context>
  <context>
    <name>core.second_screen</name>
    <message>
      <source>No screen has {v1} (connected: {v2}).</source>
      <translation>没有屏幕具有 {v1}（已连接：{v2}）。</translation>
    </message>
    <message>
      <source>Set the screen to {v1} × {v2} px, or correct the projector's size in the rig description.</source>
      <translation>请将屏幕设为 {v1} × {v2} px，或更正测量系统描述中投影仪的大小。</translation>
    </message>
    <message>
      <source>The mode of the screen {v1} has changed.</source>
      <translation>屏幕 {v1} 的模式已更改。</translation>
    </message>
    <message>
      <source>The screen {v1} cannot show the patterns pixel by pixel at a scaling of {v2}.</source>
      <translation>缩放为 {v2} 时，屏幕 {v1} 无法逐像素显示图案。</translation>
    </message>
    <message>
      <source>The screen {v1} has {v2} × {v3} px, and the patterns have {v4} × {v5} px.</source>
      <translation>屏幕 {v1} 为 {v2} × {v3} px，而图案为 {v4} × {v5} px。</translation>
    </message>
    <message>
      <source>The screen {v1} was disconnected.</source>
      <translation>屏幕 {v1} 已断开。</translation>
    </message>
    <message>
      <source>There are {v1} images, and none is {v2}.</source>
      <translation>有 {v1} 幅图像，其中没有 {v2}。</translation>
    </message>
    <message>
      <source>{v1} screens have {v2} (connected: {v3}).</source>
      <translation>有 {v1} 个屏幕具有 {v2}（已连接：{v3}）。</translation>
    </message>
  </context>
  <context>
    <name>core.settings</name>
    <message>
      <source>{v1} cannot be {v2}; it is one of {v3}</source>
      <translation>{v1} 不能为 {v2}；可为 {v3}</translation>
    </message>
  </context>
  <context>
    <name>core.simulate</name>
    <message>
      <source>Correct it; resources/worlds has examples.</source>
      <translation>请更正；resources/worlds 中有示例。</translation>
    </message>
    <message>
      <source>Export it again, or copy it again if the copy is incomplete.</source>
      <translation>请重新导出；若副本不完整，请重新复制。</translation>
    </message>
    <message>
      <source>Give an STL, PLY or OBJ file, or the name of a sample part.</source>
      <translation>请给出 STL、PLY 或 OBJ 文件，或示例工件的名称。</translation>
    </message>
    <message>
      <source>Give its unit, or scale it to {v1}…{v2} mm.</source>
      <translation>请给出其单位，或缩放到 {v1}…{v2} mm。</translation>
    </message>
    <message>
      <source>Give the path of an STL, PLY or OBJ file.</source>
      <translation>请给出 STL、PLY 或 OBJ 文件的路径。</translation>
    </message>
    <message>
      <source>Give three angles in degrees.</source>
      <translation>请给出三个以度为单位的角度。</translation>
    </message>
    <message>
      <source>Name one of {v1}, or a mesh file (STL, PLY, OBJ).</source>
      <translation>请指定 {v1} 之一，或一个网格文件（STL、PLY、OBJ）。</translation>
    </message>
    <message>
      <source>The part cannot be turned by what is no number.</source>
      <translation>零件无法按非数字的角度转动。</translation>
    </message>
    <message>
      <source>The world {v1} cannot be read: {v2}.</source>
      <translation>无法读取世界 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>The world {v1}: {v2}.</source>
      <translation>世界 {v1}：{v2}。</translation>
    </message>
    <message>
      <source>There is no sample part {v1}.</source>
      <translation>没有示例工件 {v1}。</translation>
    </message>
    <message>
      <source>an outline is sampled too coarsely to be triangulated</source>
      <translation>轮廓采样过粗，无法三角化</translation>
    </message>
    <message>
      <source>its values</source>
      <translation>其值</translation>
    </message>
    <message>
      <source>{v1} cannot be read as a mesh: {v2}.</source>
      <translation>无法将 {v1} 读作网格：{v2}。</translation>
    </message>
    <message>
      <source>{v1} contains no triangles.</source>
      <translation>{v1} 不含三角形。</translation>
    </message>
    <message>
      <source>{v1} contains no usable triangles.</source>
      <translation>{v1} 不含可用的三角形。</translation>
    </message>
    <message>
      <source>{v1} has no complete PLY header.</source>
      <translation>{v1} 没有完整的 PLY 文件头。</translation>
    </message>
    <message>
      <source>{v1} is not a supported mesh file.</source>
      <translation>{v1} 不是支持的网格文件。</translation>
    </message>
    <message>
      <source>{v1} is truncated: it has {v2} bytes, its header needs at least {v3}.</source>
      <translation>{v1} 被截断：只有 {v2} 字节，其文件头至少需要 {v3} 字节。</translation>
    </message>
    <message>
      <source>{v1} is truncated: it has {v2} of {v3} bytes.</source>
      <translation>{v1} 被截断：只有 {v3} 字节中的 {v2} 字节。</translation>
    </message>
    <message>
      <source>{v1} is truncated: it has {v2} of {v3} rows.</source>
      <translation>{v1} 被截断：只有 {v3} 行中的 {v2} 行。</translation>
    </message>
    <message>
      <source>{v1} is truncated: the closing line `endsolid` is missing.</source>
      <translation>{v1} 被截断：缺少结尾行 `endsolid`。</translation>
    </message>
    <message>
      <source>{v1}: the part would be {v2} mm long.</source>
      <translation>{v1}：工件将长 {v2} mm。</translation>
    </message>
  </context>
  <context>
    <name>core.table_serial</name>
    <message>
      <source> any more</source>
      <translation>（此前有应答）</translation>
    </message>
    <message>
      <source>Check its emergency stop and interlocks.</source>
      <translation>请检查其急停和联锁。</translation>
    </message>
    <message>
      <source>Check port, address, baud rate and command table.</source>
      <translation>请检查端口、地址、波特率和命令表。</translation>
    </message>
    <message>
      <source>Check power, cable, address and baud rate.</source>
      <translation>请检查电源、电缆、地址和波特率。</translation>
    </message>
    <message>
      <source>Check the command table, and that no other program controls the table.</source>
      <translation>请检查命令表，并确认没有其他程序控制该转台。</translation>
    </message>
    <message>
      <source>Check the controller, its command table, address and baud rate.</source>
      <translation>请检查控制器、其命令表、地址和波特率。</translation>
    </message>
    <message>
      <source>Check the port, and that no other program uses it.</source>
      <translation>请检查端口，并确认没有其他程序使用。</translation>
    </message>
    <message>
      <source>Check the state of the controller and its limits.</source>
      <translation>请检查控制器的状态及其限位。</translation>
    </message>
    <message>
      <source>Choose limits less than 360° apart in the rig description.</source>
      <translation>请在测量系统描述中选择相差小于 360° 的限位。</translation>
    </message>
    <message>
      <source>Name one of {v1}, or the path of a table (.toml).</source>
      <translation>请指定 {v1} 之一，或命令表 (.toml) 的路径。</translation>
    </message>
    <message>
      <source>Remove the cause and reset the controller, then try again.</source>
      <translation>请排除原因并复位控制器，然后重试。</translation>
    </message>
    <message>
      <source>There is no command table {v1}.</source>
      <translation>没有命令表 {v1}。</translation>
    </message>
    <message>
      <source>command {v1} has an unknown place {v2} (known: {v3})</source>
      <translation>命令 {v1} 含有未知的位置 {v2}（已知：{v3}）</translation>
    </message>
    <message>
      <source>conditions.moving, and conditions.refused or acknowledge, are needed: nothing is believed that was not read back</source>
      <translation>需要 conditions.moving，以及 conditions.refused 或 acknowledge：未读回的内容一律不采信</translation>
    </message>
    <message>
      <source>conditions.{v1} names a query or group that is not described</source>
      <translation>conditions.{v1} 指定了没有描述的查询或组</translation>
    </message>
    <message>
      <source>give either matches or differs</source>
      <translation>请给出 matches 或 differs 之一</translation>
    </message>
    <message>
      <source>is not a regular expression: {v1}</source>
      <translation>不是正则表达式：{v1}</translation>
    </message>
    <message>
      <source>no reply ({v1})</source>
      <translation>没有应答（{v1}）</translation>
    </message>
    <message>
      <source>queries.position with a group value is not described</source>
      <translation>没有描述带组 value 的 queries.position</translation>
    </message>
    <message>
      <source>reply is not a regular expression: {v1}</source>
      <translation>reply 不是正则表达式：{v1}</translation>
    </message>
    <message>
      <source>reply needs a named group, such as (?P&lt;value&gt;…)</source>
      <translation>reply 需要命名组，如 (?P&lt;value&gt;…)</translation>
    </message>
    <message>
      <source>sequences.move sends no goal</source>
      <translation>sequences.move 没有发送目标</translation>
    </message>
    <message>
      <source>the command table</source>
      <translation>命令表</translation>
    </message>
    <message>
      <source>{v1} Connect again, and find the reference anew if the controller lost it.</source>
      <translation>{v1} 请重新连接，若控制器丢失参考点，请重新回参考点。</translation>
    </message>
    <message>
      <source>{v1} answered the query {v2} with {v3} ({v4}), which is no reply of a {v5}.</source>
      <translation>{v1} 对查询 {v2} 应答 {v3} ({v4})，不是 {v5} 的应答。</translation>
    </message>
    <message>
      <source>{v1} at {v2} did not repeat {v3} ({v4}).</source>
      <translation>{v2} 处的 {v1} 没有重复 {v3} ({v4})。</translation>
    </message>
    <message>
      <source>{v1} at {v2} did not reply ({v3}).</source>
      <translation>{v2} 上的 {v1} 没有应答（{v3}）。</translation>
    </message>
    <message>
      <source>{v1} at {v2} does not answer{v3}: {v4}.</source>
      <translation>{v2} 处的 {v1} 不应答{v3}：{v4}。</translation>
    </message>
    <message>
      <source>{v1} at {v2} sent no valid reply ({v3}).</source>
      <translation>{v2} 处的 {v1} 没有发送有效应答 ({v3})。</translation>
    </message>
    <message>
      <source>{v1} came to rest {v2}° away from its goal.</source>
      <translation>{v1} 停止时偏离目标 {v2}°。</translation>
    </message>
    <message>
      <source>{v1} cannot be read as a command table: {v2}.</source>
      <translation>{v1} 不能读作命令表：{v2}。</translation>
    </message>
    <message>
      <source>{v1} does not identify itself as a {v2}.</source>
      <translation>{v1} 没有表明自己是 {v2}。</translation>
    </message>
    <message>
      <source>{v1} does not switch its motor on.</source>
      <translation>{v1} 没有接通其电机。</translation>
    </message>
    <message>
      <source>{v1} refused {v2} with {v3}.</source>
      <translation>{v1} 以 {v3} 拒绝了 {v2}。</translation>
    </message>
    <message>
      <source>{v1} refused {v2}: {v3}.</source>
      <translation>{v1} 拒绝了 {v2}：{v3}。</translation>
    </message>
    <message>
      <source>{v1}: its controller counts modulo one turn, and the limits {v2}…{v3}° do not determine the turn.</source>
      <translation>{v1}：其控制器按一圈取模计数，而限位 {v2}…{v3}° 不能确定圈数。</translation>
    </message>
    <message>
      <source>{v1}: the goal {v2}° is outside {v3}…{v4}°.</source>
      <translation>{v1}：目标 {v2}° 超出 {v3}…{v4}°。</translation>
    </message>
  </context>
  <context>
    <name>core.virtual_rig</name>
    <message>
      <source>Check the device for obstructions, then try again.</source>
      <translation>请检查设备有无阻碍，然后重试。</translation>
    </message>
    <message>
      <source>Lengthen the period.</source>
      <translation>请加大周期。</translation>
    </message>
    <message>
      <source>Name cameras of this rig.</source>
      <translation>请指定此测量系统的相机。</translation>
    </message>
    <message>
      <source>Request one of: {v1}.</source>
      <translation>请要求其一：{v1}。</translation>
    </message>
    <message>
      <source>The virtual rig has no {v1} to put on the table.</source>
      <translation>虚拟测量系统没有 {v1} 可放在转台上。</translation>
    </message>
    <message>
      <source>Virtual rig: setting world.knocked_deg names camera {v1}.</source>
      <translation>虚拟测量系统：设置 world.knocked_deg 指定了相机 {v1}。</translation>
    </message>
    <message>
      <source>the virtual rig</source>
      <translation>虚拟测量系统</translation>
    </message>
    <message>
      <source>{v1} did not finish within {v2} s.</source>
      <translation>{v1} 在 {v2} s 内没有完成。</translation>
    </message>
    <message>
      <source>{v1}: the angle {v2}° is outside {v3}.</source>
      <translation>{v1}：角度 {v2}° 超出 {v3}。</translation>
    </message>
    <message>
      <source>{v1}: the position {v2} mm is outside {v3}…{v4} mm.</source>
      <translation>{v1}：位置 {v2} mm 超出 {v3}…{v4} mm。</translation>
    </message>
  </context>
  <context>
    <name>images</name>
    <message>
      <source> &amp;nbsp; </source>
      <translation> &amp;nbsp; </translation>
    </message>
    <message>
      <source> · {share} saturated</source>
      <translation> · {share} 饱和</translation>
    </message>
    <message>
      <source> – too bright</source>
      <translation> – 过亮</translation>
    </message>
    <message>
      <source>, no values</source>
      <translation>，没有值</translation>
    </message>
    <message>
      <source>Absolute phase</source>
      <translation>绝对相位</translation>
    </message>
    <message>
      <source>Amplitude of the fringes at the exposure used</source>
      <translation>所用曝光的条纹幅值</translation>
    </message>
    <message>
      <source>Column [px]</source>
      <translation>列 [px]</translation>
    </message>
    <message>
      <source>Column of the first end</source>
      <translation>第一端点的列</translation>
    </message>
    <message>
      <source>Column of the second end</source>
      <translation>第二端点的列</translation>
    </message>
    <message>
      <source>Distance [px]</source>
      <translation>距离 [px]</translation>
    </message>
    <message>
      <source>Exposure</source>
      <translation>曝光</translation>
    </message>
    <message>
      <source>From row</source>
      <translation>起始行</translation>
    </message>
    <message>
      <source>Grey level</source>
      <translation>灰度</translation>
    </message>
    <message>
      <source>Image</source>
      <translation>图像</translation>
    </message>
    <message>
      <source>Images</source>
      <translation>图像</translation>
    </message>
    <message>
      <source>Longest exposure in which the pixel is not saturated</source>
      <translation>像素未饱和的最长曝光</translation>
    </message>
    <message>
      <source>Map</source>
      <translation>图</translation>
    </message>
    <message>
      <source>Median level {median} · saturated {saturated}</source>
      <translation>中位灰度 {median} · 饱和 {saturated}</translation>
    </message>
    <message>
      <source>Modulation</source>
      <translation>调制度</translation>
    </message>
    <message>
      <source>No image yet.</source>
      <translation>尚无图像。</translation>
    </message>
    <message>
      <source>No. {place}</source>
      <translation>编号 {place}</translation>
    </message>
    <message>
      <source>Phase</source>
      <translation>相位</translation>
    </message>
    <message>
      <source>Phase within one period of the finest fringes</source>
      <translation>最细条纹一个周期内的相位</translation>
    </message>
    <message>
      <source>Picture</source>
      <translation>图像</translation>
    </message>
    <message>
      <source>Profile</source>
      <translation>剖面</translation>
    </message>
    <message>
      <source>Reason</source>
      <translation>原因</translation>
    </message>
    <message>
      <source>Row [px]</source>
      <translation>行 [px]</translation>
    </message>
    <message>
      <source>Row of the first end</source>
      <translation>第一端点的行</translation>
    </message>
    <message>
      <source>Row of the second end</source>
      <translation>第二端点的行</translation>
    </message>
    <message>
      <source>Row {row}, column {column}: {level}</source>
      <translation>第 {row} 行，第 {column} 列：{level}</translation>
    </message>
    <message>
      <source>Save table…</source>
      <translation>保存表格…</translation>
    </message>
    <message>
      <source>Standard deviation of the absolute phase</source>
      <translation>绝对相位的标准差</translation>
    </message>
    <message>
      <source>Standard deviation σ of the phase</source>
      <translation>相位的标准差 σ</translation>
    </message>
    <message>
      <source>Stored images, one by one</source>
      <translation>逐张查看已存图像</translation>
    </message>
    <message>
      <source>The values of all maps along the line, as CSV</source>
      <translation>沿直线的所有图的数值，CSV</translation>
    </message>
    <message>
      <source>The wheel zooms, dragging moves the image, a double click shows all of it.</source>
      <translation>滚轮缩放，拖动移动图像，双击显示整幅图像。</translation>
    </message>
    <message>
      <source>Valid</source>
      <translation>有效</translation>
    </message>
    <message>
      <source>Why a pixel has no phase</source>
      <translation>像素没有相位的原因</translation>
    </message>
    <message>
      <source>Wrapped</source>
      <translation>包裹</translation>
    </message>
    <message>
      <source>Wrapped phase</source>
      <translation>包裹相位</translation>
    </message>
    <message>
      <source>body</source>
      <translation>body</translation>
    </message>
    <message>
      <source>caption</source>
      <translation>caption</translation>
    </message>
    <message>
      <source>column</source>
      <translation>列</translation>
    </message>
    <message>
      <source>grey levels</source>
      <translation>灰度</translation>
    </message>
    <message>
      <source>soft</source>
      <translation>soft</translation>
    </message>
    <message>
      <source>to row</source>
      <translation>至行</translation>
    </message>
    <message>
      <source>{text}, image {text_2}</source>
      <translation>{text}，图像 {text_2}</translation>
    </message>
    <message>
      <source>{words}, {count} pixels{ends}</source>
      <translation>{words}，{count} 个像素{ends}</translation>
    </message>
    <message>
      <source>{words}, {width} × {height} px</source>
      <translation>{words}，{width} × {height} px</translation>
    </message>
  </context>
  <context>
    <name>inspection</name>
    <message>
      <source> {lost} points lie farther than {search_mm} from the nominal.</source>
      <translation> {lost} 个点距名义模型超过 {search_mm}。</translation>
    </message>
    <message>
      <source>, form {form_error_mm}</source>
      <translation>，形状误差 {form_error_mm}</translation>
    </message>
    <message>
      <source>; free: {list}</source>
      <translation>；自由：{list}</translation>
    </message>
    <message>
      <source>; with its bonus {upper}</source>
      <translation>；含补偿公差 {upper}</translation>
    </message>
    <message>
      <source>A ball bar, a gauge block, or a length of the part that a better machine has measured. What it is off, the other lengths are off too, as far as their errors are shared: they are corrected by it, and their uncertainty becomes smaller.</source>
      <translation>球棒、量块，或由更精密的设备测得的零件长度。只要误差是共有的，其他长度就会有相同的偏差：它们据此修正，不确定度随之减小。</translation>
    </message>
    <message>
      <source>A plane fixes three degrees of freedom, a line or axis two more, a point the last one.</source>
      <translation>平面确定三个自由度，直线或轴线再确定两个，点确定最后一个。</translation>
    </message>
    <message>
      <source>A size cannot be negative.</source>
      <translation>大小不能为负。</translation>
    </message>
    <message>
      <source>A, B and C in their order; each fixes what the earlier ones leave free.</source>
      <translation>依次为 A、B、C；每个确定前面留下的自由度。</translation>
    </message>
    <message>
      <source>Add</source>
      <translation>添加</translation>
    </message>
    <message>
      <source>Add a distance, an angle, a diameter or a radius to the inspection program; “Tolerance…” in the list of features adds tolerance zones</source>
      <translation>向检测程序添加距离、角度、直径或半径；特征列表中的“公差…”用于添加公差带</translation>
    </message>
    <message>
      <source>Add a feature…</source>
      <translation>添加特征…</translation>
    </message>
    <message>
      <source>Add dimension</source>
      <translation>添加尺寸</translation>
    </message>
    <message>
      <source>Add it to the inspection program and measure it</source>
      <translation>添加到检测程序并测量</translation>
    </message>
    <message>
      <source>Add the feature to the program and measure it; it can be undone</source>
      <translation>将该特征加入程序并测量；可以撤销</translation>
    </message>
    <message>
      <source>Add the proposed dimension to the program and measure it (Enter)</source>
      <translation>将建议的尺寸添加到程序并测量 (Enter)</translation>
    </message>
    <message>
      <source>Add to the inspection program</source>
      <translation>添加到检测程序</translation>
    </message>
    <message>
      <source>Added to the inspection program, it is measured every time; its lines can also be copied to another program.</source>
      <translation>添加到检测程序后每次都会测量；其文字也可复制到其他程序。</translation>
    </message>
    <message>
      <source>Align by datums, 3-2-1 or reference points. To keep the best fit, state it in the text of the program.</source>
      <translation>请按基准、3-2-1 或参考点对齐。若保留最佳拟合，请在程序文本中写明。</translation>
    </message>
    <message>
      <source>Align by these elements and measure everything again; it can be undone</source>
      <translation>按这些要素对齐并重新测量全部；可撤销</translation>
    </message>
    <message>
      <source>Aligned by</source>
      <translation>对齐方式</translation>
    </message>
    <message>
      <source>Alignment</source>
      <translation>对齐</translation>
    </message>
    <message>
      <source>Alignment of the part that the value refers to</source>
      <translation>该值所参照的零件对齐</translation>
    </message>
    <message>
      <source>Alignment of the program changed.</source>
      <translation>程序的对齐已更改。</translation>
    </message>
    <message>
      <source>All points as close to the nominal as possible. For comparison only: it spreads defects over the whole part.</source>
      <translation>所有点尽量接近名义模型。仅供比较：它会将缺陷分散到整个工件。</translation>
    </message>
    <message>
      <source>All that refers to the feature follows; it can be undone</source>
      <translation>所有引用该特征之处随之更改；可以撤销</translation>
    </message>
    <message>
      <source>An inspection program fits features to the measured points and compares their dimensions with the nominal.</source>
      <translation>检测程序将特征拟合到测量点，并将其尺寸与名义值比较。</translation>
    </message>
    <message>
      <source>Angle</source>
      <translation>角度</translation>
    </message>
    <message>
      <source>Angle step</source>
      <translation>角度间隔</translation>
    </message>
    <message>
      <source>Angularity</source>
      <translation>倾斜度</translation>
    </message>
    <message>
      <source>Apply</source>
      <translation>应用</translation>
    </message>
    <message>
      <source>Available when the points have been compared with the nominal (CAD).</source>
      <translation>测量点与名义模型（CAD）比较完成后即可使用。</translation>
    </message>
    <message>
      <source>Average the colours of neighbouring points; values, extremes and the histogram use every point as measured</source>
      <translation>对邻点颜色取平均；数值、极值和直方图使用实测的每个点</translation>
    </message>
    <message>
      <source>Axis that the section is normal to</source>
      <translation>截面所垂直的轴</translation>
    </message>
    <message>
      <source>Before the change</source>
      <translation>更改前</translation>
    </message>
    <message>
      <source>Before the change: {value}, {verdict}</source>
      <translation>更改前：{value}，{verdict}</translation>
    </message>
    <message>
      <source>Best fit</source>
      <translation>最佳拟合</translation>
    </message>
    <message>
      <source>Certified length</source>
      <translation>证书长度</translation>
    </message>
    <message>
      <source>Certified length…</source>
      <translation>证书长度…</translation>
    </message>
    <message>
      <source>Change distance</source>
      <translation>更改距离</translation>
    </message>
    <message>
      <source>Change nothing</source>
      <translation>不作更改</translation>
    </message>
    <message>
      <source>Changes are kept for the next time, and measured only then</source>
      <translation>更改会保留到下次，到那时才测量</translation>
    </message>
    <message>
      <source>Changes of before that were not measured yet. Ctrl+Z shows the program as it is.</source>
      <translation>以前的更改尚未测量。按 Ctrl+Z 显示当前的程序。</translation>
    </message>
    <message>
      <source>Characteristic</source>
      <translation>几何特征</translation>
    </message>
    <message>
      <source>Check the program and measure what has changed</source>
      <translation>检查程序并测量更改的内容</translation>
    </message>
    <message>
      <source>Choose features here, or click them in the list</source>
      <translation>在此选择特征，或在列表中单击</translation>
    </message>
    <message>
      <source>Choose the nominal</source>
      <translation>选择名义模型</translation>
    </message>
    <message>
      <source>Choose the nominal of the part: a mesh or a STEP file</source>
      <translation>选择工件的名义模型：网格或 STEP 文件</translation>
    </message>
    <message>
      <source>Choose two different features</source>
      <translation>请选择两个不同的特征</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translation>选择…</translation>
    </message>
    <message>
      <source>Circle</source>
      <translation>圆</translation>
    </message>
    <message>
      <source>Circle through the points</source>
      <translation>过各点的圆</translation>
    </message>
    <message>
      <source>Circular runout</source>
      <translation>圆跳动</translation>
    </message>
    <message>
      <source>Click a measured point</source>
      <translation>单击一个测量点</translation>
    </message>
    <message>
      <source>Click faces of the CAD model as elements, in their order; Esc ends</source>
      <translation>按顺序单击 CAD 模型的面作为要素；Esc 结束</translation>
    </message>
    <message>
      <source>Click faces of the CAD model to select them as features; Esc ends</source>
      <translation>单击 CAD 模型的面以选作特征；Esc 结束</translation>
    </message>
    <message>
      <source>Click faces of the CAD model: first the feature, then its datums; Esc ends</source>
      <translation>点击 CAD 模型的面：先选要素，再选其基准；按 Esc 结束</translation>
    </message>
    <message>
      <source>Close</source>
      <translation>关闭</translation>
    </message>
    <message>
      <source>Coaxiality</source>
      <translation>同轴度</translation>
    </message>
    <message>
      <source>Colour scale stored with the inspection program.</source>
      <translation>色标已随检测程序保存。</translation>
    </message>
    <message>
      <source>Colours</source>
      <translation>颜色</translation>
    </message>
    <message>
      <source>Common datum (A-B)</source>
      <translation>公共基准（A-B）</translation>
    </message>
    <message>
      <source>Common datum (A-B) with</source>
      <translation>公共基准（A-B）的另一特征</translation>
    </message>
    <message>
      <source>Concentricity</source>
      <translation>同心度</translation>
    </message>
    <message>
      <source>Condition</source>
      <translation>要求</translation>
    </message>
    <message>
      <source>Cone</source>
      <translation>圆锥</translation>
    </message>
    <message>
      <source>Cone angle</source>
      <translation>锥角</translation>
    </message>
    <message>
      <source>Construct</source>
      <translation>构造</translation>
    </message>
    <message>
      <source>Construct a feature from those selected</source>
      <translation>由所选特征构造特征</translation>
    </message>
    <message>
      <source>Constructed from</source>
      <translation>构造自</translation>
    </message>
    <message>
      <source>Constructed from {names}</source>
      <translation>构造自 {names}</translation>
    </message>
    <message>
      <source>Coordinates</source>
      <translation>坐标</translation>
    </message>
    <message>
      <source>Copies</source>
      <translation>数量</translation>
    </message>
    <message>
      <source>Copy its lines</source>
      <translation>复制其文字</translation>
    </message>
    <message>
      <source>Copy rows</source>
      <translation>复制行</translation>
    </message>
    <message>
      <source>Correct by it</source>
      <translation>据此修正</translation>
    </message>
    <message>
      <source>Correct nothing by this length</source>
      <translation>不按此长度作任何修正</translation>
    </message>
    <message>
      <source>Create</source>
      <translation>创建</translation>
    </message>
    <message>
      <source>Create a circle, slot, line, edge or hole pattern by clicking in the picture</source>
      <translation>在图像中单击以创建圆、槽、直线、棱边或孔组</translation>
    </message>
    <message>
      <source>Cut the part by a plane and show the deviations along the section</source>
      <translation>用平面剖切工件并显示沿截面的偏差</translation>
    </message>
    <message>
      <source>Cutting</source>
      <translation>剖切</translation>
    </message>
    <message>
      <source>Cylindricity</source>
      <translation>圆柱度</translation>
    </message>
    <message>
      <source>Datum</source>
      <translation>基准</translation>
    </message>
    <message>
      <source>Datum 1</source>
      <translation>基准 1</translation>
    </message>
    <message>
      <source>Datum 2</source>
      <translation>基准 2</translation>
    </message>
    <message>
      <source>Datum 3</source>
      <translation>基准 3</translation>
    </message>
    <message>
      <source>Datum letter of {name}</source>
      <translation>{name} 的基准字母</translation>
    </message>
    <message>
      <source>Datums</source>
      <translation>基准</translation>
    </message>
    <message>
      <source>Decision rule</source>
      <translation>判定规则</translation>
    </message>
    <message>
      <source>Define a geometrical tolerance of the first selected feature, the others as its datums</source>
      <translation>为所选的第一个要素定义几何公差，其余要素作为基准</translation>
    </message>
    <message>
      <source>Del</source>
      <translation>Del</translation>
    </message>
    <message>
      <source>Delete</source>
      <translation>删除</translation>
    </message>
    <message>
      <source>Delete the pattern {name}</source>
      <translation>删除阵列 {name}</translation>
    </message>
    <message>
      <source>Deviation</source>
      <translation>偏差</translation>
    </message>
    <message>
      <source>Deviation from the nominal, in mm, on the CAD model or on the measured points</source>
      <translation>与名义模型的偏差，mm，显示在 CAD 模型或测量点上</translation>
    </message>
    <message>
      <source>Deviations × {gain}</source>
      <translation>偏差 × {gain}</translation>
    </message>
    <message>
      <source>Diameter</source>
      <translation>直径</translation>
    </message>
    <message>
      <source>Dimension</source>
      <translation>尺寸</translation>
    </message>
    <message>
      <source>Dimensions</source>
      <translation>尺寸</translation>
    </message>
    <message>
      <source>Direction</source>
      <translation>方向</translation>
    </message>
    <message>
      <source>Distance from the edge within which points are not used</source>
      <translation>距棱边此距离以内的点不使用</translation>
    </message>
    <message>
      <source>Distance of an offset plane or a point on the axis</source>
      <translation>偏置平面或轴上点的距离</translation>
    </message>
    <message>
      <source>Distance…</source>
      <translation>距离…</translation>
    </message>
    <message>
      <source>Each point</source>
      <translation>逐点</translation>
    </message>
    <message>
      <source>Edit the inspection program as text: alignment, features, dimensions</source>
      <translation>以文本编辑检测程序：对齐、特征、尺寸</translation>
    </message>
    <message>
      <source>Edit the nominal</source>
      <translation>编辑名义值</translation>
    </message>
    <message>
      <source>Edit the tolerance</source>
      <translation>编辑公差</translation>
    </message>
    <message>
      <source>Edit the tolerance frame…</source>
      <translation>编辑公差框格…</translation>
    </message>
    <message>
      <source>Enter a number, such as 24.5.</source>
      <translation>请输入数字，例如 24.5。</translation>
    </message>
    <message>
      <source>Enter the nominal value</source>
      <translation>请输入名义值</translation>
    </message>
    <message>
      <source>Evaluate every dimension with this version; the results are stored when the program is saved</source>
      <translation>用此版本重新评定所有尺寸；保存程序时一并保存结果</translation>
    </message>
    <message>
      <source>Evaluated by an earlier version of MeasureApp</source>
      <translation>由 MeasureApp 的早期版本评定</translation>
    </message>
    <message>
      <source>Evaluated by version {version} of MeasureApp</source>
      <translation>由 MeasureApp {version} 版评定</translation>
    </message>
    <message>
      <source>Expanded uncertainty (k = 2)</source>
      <translation>扩展不确定度 (k = 2)</translation>
    </message>
    <message>
      <source>F2 edits a cell, Enter zooms to the features of the row.</source>
      <translation>F2 编辑单元格，Enter 缩放到该行的特征。</translation>
    </message>
    <message>
      <source>Feature</source>
      <translation>特征</translation>
    </message>
    <message>
      <source>Features</source>
      <translation>特征</translation>
    </message>
    <message>
      <source>Features and dimensions in TOML; the help of the Inspect page lists all options.</source>
      <translation>TOML 格式的特征和尺寸；“检测”页的帮助列出所有选项。</translation>
    </message>
    <message>
      <source>Filled, not measured</source>
      <translation>已填补，未测量</translation>
    </message>
    <message>
      <source>First feature</source>
      <translation>第一特征</translation>
    </message>
    <message>
      <source>Fit a plane, cylinder, sphere or cone around a point you click</source>
      <translation>在单击的点周围拟合平面、圆柱、球或圆锥</translation>
    </message>
    <message>
      <source>Flatness</source>
      <translation>平面度</translation>
    </message>
    <message>
      <source>Follows the nominal features</source>
      <translation>随名义特征变化</translation>
    </message>
    <message>
      <source>Form</source>
      <translation>形状误差</translation>
    </message>
    <message>
      <source>Form deviation</source>
      <translation>形状误差</translation>
    </message>
    <message>
      <source>Found on the part: {found} of {count}.</source>
      <translation>在工件上找到：{count} 个中的 {found} 个。</translation>
    </message>
    <message>
      <source>Found on the part: {size}, {points}.</source>
      <translation>在工件上找到：{size}，{points}。</translation>
    </message>
    <message>
      <source>Gap</source>
      <translation>间隙</translation>
    </message>
    <message>
      <source>Greatest diameter</source>
      <translation>最大直径</translation>
    </message>
    <message>
      <source>Grow a</source>
      <translation>生长</translation>
    </message>
    <message>
      <source>Height of the slice of the wall that is measured</source>
      <translation>所测壁面切片的高度</translation>
    </message>
    <message>
      <source>Hold Ctrl to select several features.</source>
      <translation>按住 Ctrl 选择多个特征。</translation>
    </message>
    <message>
      <source>Hole pattern</source>
      <translation>孔组</translation>
    </message>
    <message>
      <source>In use: {name}, {rms_mm} rms.</source>
      <translation>使用中：{name}，均方根 {rms_mm}。</translation>
    </message>
    <message>
      <source>Inspect</source>
      <translation>检测</translation>
    </message>
    <message>
      <source>Inspection program</source>
      <translation>检测程序</translation>
    </message>
    <message>
      <source>Inspection programs (*.toml)</source>
      <translation>检测程序 (*.toml)</translation>
    </message>
    <message>
      <source>Intersection</source>
      <translation>相交</translation>
    </message>
    <message>
      <source>Kind</source>
      <translation>类型</translation>
    </message>
    <message>
      <source>Kind of dimension</source>
      <translation>尺寸类型</translation>
    </message>
    <message>
      <source>Labels</source>
      <translation>标签</translation>
    </message>
    <message>
      <source>Least diameter</source>
      <translation>最小直径</translation>
    </message>
    <message>
      <source>Least material</source>
      <translation>最小实体</translation>
    </message>
    <message>
      <source>Leave the program as it is (Esc)</source>
      <translation>程序保持不变（Esc）</translation>
    </message>
    <message>
      <source>Length</source>
      <translation>长度</translation>
    </message>
    <message>
      <source>Lengths are corrected by {name}.</source>
      <translation>长度已按 {name} 修正。</translation>
    </message>
    <message>
      <source>Lengths in mm, U for k = 2, verdicts by {rule_name}.</source>
      <translation>长度单位 mm，U 为 k = 2，判定依据 {rule_name}。</translation>
    </message>
    <message>
      <source>Limits as deviations from the nominal. Type ±0.1, +0.1/-0.05, max 0.05, H7 or 2768-m.</source>
      <translation>以对名义值的偏差给出限值。输入 ±0.1、+0.1/-0.05、max 0.05、H7 或 2768-m。</translation>
    </message>
    <message>
      <source>Line</source>
      <translation>直线</translation>
    </message>
    <message>
      <source>Line profile</source>
      <translation>线轮廓度</translation>
    </message>
    <message>
      <source>Line through the points</source>
      <translation>过各点的直线</translation>
    </message>
    <message>
      <source>Lines of {name} copied.</source>
      <translation>已复制 {name} 的文字。</translation>
    </message>
    <message>
      <source>List</source>
      <translation>列表</translation>
    </message>
    <message>
      <source>Long direction</source>
      <translation>长轴方向</translation>
    </message>
    <message>
      <source>Material condition</source>
      <translation>实体要求</translation>
    </message>
    <message>
      <source>Maximum</source>
      <translation>最大值</translation>
    </message>
    <message>
      <source>Maximum material</source>
      <translation>最大实体</translation>
    </message>
    <message>
      <source>Mean of the points nearby</source>
      <translation>邻近点的平均值</translation>
    </message>
    <message>
      <source>Mean {mean}, rms {rms}; 95 % within {p95}.</source>
      <translation>平均 {mean}，均方根 {rms}；95 % 在 {p95} 以内。</translation>
    </message>
    <message>
      <source>Measure a cloud or mesh by a nominal or an inspection program</source>
      <translation>按名义模型或检测程序测量点云或网格</translation>
    </message>
    <message>
      <source>Measure a file…</source>
      <translation>测量文件…</translation>
    </message>
    <message>
      <source>Measure again</source>
      <translation>重新测量</translation>
    </message>
    <message>
      <source>Measure all</source>
      <translation>全部测量</translation>
    </message>
    <message>
      <source>Measure everything that is stale</source>
      <translation>测量所有过期项</translation>
    </message>
    <message>
      <source>Measure the lengths again, corrected by this one; it can be undone</source>
      <translation>按此长度修正并重新测量各长度；可以撤销</translation>
    </message>
    <message>
      <source>Measured</source>
      <translation>测得值</translation>
    </message>
    <message>
      <source>Measured minus nominal</source>
      <translation>测量值减名义值</translation>
    </message>
    <message>
      <source>Measured surface; hatched where it was filled, not measured</source>
      <translation>测量的表面；已填补而未测量处为阴影线</translation>
    </message>
    <message>
      <source>Measured value, in mm unless a unit is given</source>
      <translation>测量值，未注明单位时为 mm</translation>
    </message>
    <message>
      <source>Measuring what has changed…</source>
      <translation>正在测量更改的内容…</translation>
    </message>
    <message>
      <source>Measuring…</source>
      <translation>正在测量…</translation>
    </message>
    <message>
      <source>Merged points</source>
      <translation>合并后的点</translation>
    </message>
    <message>
      <source>Mid-plane</source>
      <translation>中间平面</translation>
    </message>
    <message>
      <source>Midpoint</source>
      <translation>中点</translation>
    </message>
    <message>
      <source>Minimum</source>
      <translation>最小值</translation>
    </message>
    <message>
      <source>Minimum {value}</source>
      <translation>最小 {value}</translation>
    </message>
    <message>
      <source>Move down</source>
      <translation>下移</translation>
    </message>
    <message>
      <source>Move up</source>
      <translation>上移</translation>
    </message>
    <message>
      <source>New feature</source>
      <translation>新建特征</translation>
    </message>
    <message>
      <source>New geometrical tolerance</source>
      <translation>新建几何公差</translation>
    </message>
    <message>
      <source>New geometrical tolerance…</source>
      <translation>新建几何公差…</translation>
    </message>
    <message>
      <source>No alignment was chosen: a best fit was used, which spreads defects over the whole part.</source>
      <translation>未选择对齐：使用了最佳拟合，它会将缺陷分散到整个工件。</translation>
    </message>
    <message>
      <source>No dimension fits the filter. Clear the search, or show all verdicts.</source>
      <translation>没有符合筛选条件的尺寸。请清除搜索，或显示所有判定。</translation>
    </message>
    <message>
      <source>No dimension fits these features together. Select one or two of them, or press Tolerance…</source>
      <translation>没有适合这些特征组合的尺寸。请选择其中一个或两个，或按“公差…”</translation>
    </message>
    <message>
      <source>No dimension fits this feature alone.</source>
      <translation>没有尺寸适合单独的这个特征。</translation>
    </message>
    <message>
      <source>No dimensions yet. Select features in the list Features, or add one with Dimension above the picture.</source>
      <translation>尚无尺寸。请在“特征”列表中选择特征，或用图像上方的“尺寸”添加。</translation>
    </message>
    <message>
      <source>No extreme that its neighbours confirm.</source>
      <translation>没有邻点证实的极值。</translation>
    </message>
    <message>
      <source>No features yet. Press Pick faces or Feature and click the part, or write them with Program.</source>
      <translation>尚无特征。请按“选取面”或“特征”后点击工件，或用“程序”编写。</translation>
    </message>
    <message>
      <source>No inspection yet.</source>
      <translation>尚无检测。</translation>
    </message>
    <message>
      <source>No intersection</source>
      <translation>无交线</translation>
    </message>
    <message>
      <source>No tolerance: there is no verdict</source>
      <translation>无公差：不作判定</translation>
    </message>
    <message>
      <source>Nominal</source>
      <translation>名义值</translation>
    </message>
    <message>
      <source>Nominal value</source>
      <translation>名义值</translation>
    </message>
    <message>
      <source>Nominal, in italics where it is that of the CAD model</source>
      <translation>名义值，与 CAD 模型相同时为斜体</translation>
    </message>
    <message>
      <source>Nominals (*.stl *.ply *.obj *.step *.stp)</source>
      <translation>名义模型 (*.stl *.ply *.obj *.step *.stp)</translation>
    </message>
    <message>
      <source>Nominal…</source>
      <translation>名义模型…</translation>
    </message>
    <message>
      <source>None</source>
      <translation>无</translation>
    </message>
    <message>
      <source>Not certified</source>
      <translation>无证书</translation>
    </message>
    <message>
      <source>Not measured</source>
      <translation>未测量</translation>
    </message>
    <message>
      <source>Not measured: {total} of the nominal's surface (not seen {not_seen}, filled {filled}, too far {too_far})</source>
      <translation>未测量：名义表面的 {total}（未看到 {not_seen}，已填补 {filled}，过远 {too_far}）</translation>
    </message>
    <message>
      <source>Not measured: {unmeasured_share} of the nominal's surface</source>
      <translation>未测量：名义表面的 {unmeasured_share}</translation>
    </message>
    <message>
      <source>Nothing measured yet</source>
      <translation>尚未测量</translation>
    </message>
    <message>
      <source>Offset (UZ)</source>
      <translation>偏移（UZ）</translation>
    </message>
    <message>
      <source>Offset of the zone, out of the material</source>
      <translation>公差带向材料外的偏移</translation>
    </message>
    <message>
      <source>Offset plane</source>
      <translation>偏置平面</translation>
    </message>
    <message>
      <source>On the CAD model</source>
      <translation>在 CAD 模型上</translation>
    </message>
    <message>
      <source>On the points</source>
      <translation>在点上</translation>
    </message>
    <message>
      <source>Order of the dimensions changed.</source>
      <translation>尺寸的顺序已更改。</translation>
    </message>
    <message>
      <source>Order of the report</source>
      <translation>报告顺序</translation>
    </message>
    <message>
      <source>Parallelism</source>
      <translation>平行度</translation>
    </message>
    <message>
      <source>Paste them into an inspection program.</source>
      <translation>请将其粘贴到检测程序中。</translation>
    </message>
    <message>
      <source>Pattern centre</source>
      <translation>阵列中心</translation>
    </message>
    <message>
      <source>Perpendicularity</source>
      <translation>垂直度</translation>
    </message>
    <message>
      <source>Pick faces</source>
      <translation>选取面</translation>
    </message>
    <message>
      <source>Pitch circle</source>
      <translation>分布圆</translation>
    </message>
    <message>
      <source>Plane</source>
      <translation>平面</translation>
    </message>
    <message>
      <source>Plane fit around the clicked place</source>
      <translation>在单击处拟合的平面</translation>
    </message>
    <message>
      <source>Plane through the points</source>
      <translation>过各点的平面</translation>
    </message>
    <message>
      <source>Point</source>
      <translation>点</translation>
    </message>
    <message>
      <source>Point on the axis</source>
      <translation>轴线上的点</translation>
    </message>
    <message>
      <source>Position</source>
      <translation>位置度</translation>
    </message>
    <message>
      <source>Position of the section along the axis</source>
      <translation>截面沿轴线的位置</translation>
    </message>
    <message>
      <source>Primary datum</source>
      <translation>第一基准</translation>
    </message>
    <message>
      <source>Program edited, not saved</source>
      <translation>程序已编辑，未保存</translation>
    </message>
    <message>
      <source>Program…</source>
      <translation>程序…</translation>
    </message>
    <message>
      <source>Projection of the first onto the second</source>
      <translation>第一个在第二个上的投影</translation>
    </message>
    <message>
      <source>Proposed dimension</source>
      <translation>建议的尺寸</translation>
    </message>
    <message>
      <source>Put the tolerance into the program and measure it; it can be undone</source>
      <translation>将公差写入程序并测量；可以撤销</translation>
    </message>
    <message>
      <source>Radius</source>
      <translation>半径</translation>
    </message>
    <message>
      <source>Reading a deviation</source>
      <translation>正在读取偏差</translation>
    </message>
    <message>
      <source>Redo (Ctrl+Y)</source>
      <translation>重做 (Ctrl+Y)</translation>
    </message>
    <message>
      <source>Reference points, each along its normal; further ones take part by least squares.</source>
      <translation>参考点，各沿其法向；更多的点按最小二乘参与。</translation>
    </message>
    <message>
      <source>Regardless of size</source>
      <translation>与尺寸无关</translation>
    </message>
    <message>
      <source>Rejected</source>
      <translation>已剔除</translation>
    </message>
    <message>
      <source>Relative deviation</source>
      <translation>相对偏差</translation>
    </message>
    <message>
      <source>Remove dimension {name}</source>
      <translation>移除尺寸 {name}</translation>
    </message>
    <message>
      <source>Remove feature {name}</source>
      <translation>移除特征 {name}</translation>
    </message>
    <message>
      <source>Remove pattern {name}</source>
      <translation>移除阵列 {name}</translation>
    </message>
    <message>
      <source>Remove {entries}</source>
      <translation>移除 {entries}</translation>
    </message>
    <message>
      <source>Remove {name}</source>
      <translation>移除 {name}</translation>
    </message>
    <message>
      <source>Rename</source>
      <translation>重命名</translation>
    </message>
    <message>
      <source>Rename…</source>
      <translation>重命名…</translation>
    </message>
    <message>
      <source>Reset</source>
      <translation>重置</translation>
    </message>
    <message>
      <source>Residual at {name}</source>
      <translation>{name} 处的残差</translation>
    </message>
    <message>
      <source>Restore the nominal of the CAD features</source>
      <translation>恢复 CAD 特征的名义值</translation>
    </message>
    <message>
      <source>Results are stale</source>
      <translation>结果已过时</translation>
    </message>
    <message>
      <source>Return to the alignment of the program</source>
      <translation>恢复程序的对齐</translation>
    </message>
    <message>
      <source>Roundness</source>
      <translation>圆度</translation>
    </message>
    <message>
      <source>Save as…</source>
      <translation>另存为…</translation>
    </message>
    <message>
      <source>Save program</source>
      <translation>保存程序</translation>
    </message>
    <message>
      <source>Save program, results and report with the project (Ctrl+S)</source>
      <translation>将程序、结果和报告随项目保存 (Ctrl+S)</translation>
    </message>
    <message>
      <source>Save the inspection program</source>
      <translation>保存检测程序</translation>
    </message>
    <message>
      <source>Save the program to a file of its own</source>
      <translation>将程序保存到单独的文件</translation>
    </message>
    <message>
      <source>Search</source>
      <translation>搜索</translation>
    </message>
    <message>
      <source>Search dimensions by name or kind</source>
      <translation>按名称或类型搜索尺寸</translation>
    </message>
    <message>
      <source>Second feature</source>
      <translation>第二个特征</translation>
    </message>
    <message>
      <source>Secondary datum</source>
      <translation>第二基准</translation>
    </message>
    <message>
      <source>Section</source>
      <translation>截面</translation>
    </message>
    <message>
      <source>Section normal to</source>
      <translation>截面垂直于</translation>
    </message>
    <message>
      <source>Select features in the list, pick faces of the CAD model, or create a new feature by clicking. Fitting dimensions are then proposed.</source>
      <translation>请在列表中选择特征，选取 CAD 模型的面，或通过单击新建特征，随后会建议合适的尺寸。</translation>
    </message>
    <message>
      <source>Shape</source>
      <translation>形状</translation>
    </message>
    <message>
      <source>Shape to grow</source>
      <translation>要生长的形状</translation>
    </message>
    <message>
      <source>Show dimensions whose name or kind contains these words (Ctrl+F)</source>
      <translation>显示名称或类型包含这些词的尺寸 (Ctrl+F)</translation>
    </message>
    <message>
      <source>Show the value of every dimension in the picture</source>
      <translation>在图中显示每个尺寸的值</translation>
    </message>
    <message>
      <source>Size</source>
      <translation>大小</translation>
    </message>
    <message>
      <source>Slice</source>
      <translation>切片厚度</translation>
    </message>
    <message>
      <source>Slot</source>
      <translation>槽</translation>
    </message>
    <message>
      <source>Smooth the colours</source>
      <translation>平滑颜色</translation>
    </message>
    <message>
      <source>Smoothed, radius {radius_mm}</source>
      <translation>已平滑，半径 {radius_mm}</translation>
    </message>
    <message>
      <source>Sphere</source>
      <translation>球</translation>
    </message>
    <message>
      <source>Stale</source>
      <translation>已过期</translation>
    </message>
    <message>
      <source>Status: current, being measured, stale, or not measurable</source>
      <translation>状态：当前、正在测量、过期或无法测量</translation>
    </message>
    <message>
      <source>Step</source>
      <translation>步距</translation>
    </message>
    <message>
      <source>Step of rows</source>
      <translation>行间距</translation>
    </message>
    <message>
      <source>Store</source>
      <translation>保存</translation>
    </message>
    <message>
      <source>Store colours, range and tolerance band with the inspection program: they are used again here and in reports</source>
      <translation>将颜色、范围和公差带随检测程序保存：在此处和报告中再次使用</translation>
    </message>
    <message>
      <source>Straightness</source>
      <translation>直线度</translation>
    </message>
    <message>
      <source>Strip</source>
      <translation>条带</translation>
    </message>
    <message>
      <source>Surface deviation</source>
      <translation>表面偏差</translation>
    </message>
    <message>
      <source>Surface profile</source>
      <translation>面轮廓度</translation>
    </message>
    <message>
      <source>Symmetric tolerance</source>
      <translation>对称公差</translation>
    </message>
    <message>
      <source>Symmetric tolerance band of the colours in mm; it does not affect verdicts</source>
      <translation>颜色的对称公差带，mm；不影响判定</translation>
    </message>
    <message>
      <source>Symmetry</source>
      <translation>对称</translation>
    </message>
    <message>
      <source>Tertiary datum</source>
      <translation>第三基准</translation>
    </message>
    <message>
      <source>The coordinates of the part as they are, without an alignment.</source>
      <translation>工件坐标原样，不作对齐。</translation>
    </message>
    <message>
      <source>The dimensions appear here when the surface is complete.</source>
      <translation>表面完成后在此显示尺寸。</translation>
    </message>
    <message>
      <source>The entry was not taken over.</source>
      <translation>该输入未被采用。</translation>
    </message>
    <message>
      <source>The inspection program has changed since they were measured</source>
      <translation>测量之后检测程序已更改</translation>
    </message>
    <message>
      <source>The nominal follows the nominal features again.</source>
      <translation>名义值重新随名义特征变化。</translation>
    </message>
    <message>
      <source>Tolerance</source>
      <translation>公差</translation>
    </message>
    <message>
      <source>Tolerance band ±</source>
      <translation>公差带 ±</translation>
    </message>
    <message>
      <source>Tolerance {tolerance}</source>
      <translation>公差 {tolerance}</translation>
    </message>
    <message>
      <source>Toleranced feature</source>
      <translation>被测要素</translation>
    </message>
    <message>
      <source>Tolerance…</source>
      <translation>公差…</translation>
    </message>
    <message>
      <source>Too few features: grow some first</source>
      <translation>特征太少：请先生长一些</translation>
    </message>
    <message>
      <source>Total runout</source>
      <translation>全跳动</translation>
    </message>
    <message>
      <source>Traceability</source>
      <translation>溯源</translation>
    </message>
    <message>
      <source>Type the position; the arrow keys move it by 1 mm, Page Up and Page Down by 10 mm</source>
      <translation>输入位置；方向键每次移动 1 mm，Page Up 和 Page Down 每次移动 10 mm</translation>
    </message>
    <message>
      <source>Typed</source>
      <translation>手动输入</translation>
    </message>
    <message>
      <source>Uncertainty budget (k = 2)</source>
      <translation>不确定度预算 (k = 2)</translation>
    </message>
    <message>
      <source>Undo the last point, distance, feature or change of the program</source>
      <translation>撤销上一个点、距离、特征或程序更改</translation>
    </message>
    <message>
      <source>Undo: {undotext}</source>
      <translation>撤销：{undotext}</translation>
    </message>
    <message>
      <source>What depends on the feature is measured again; it can be undone</source>
      <translation>依赖该特征的内容将重新测量；可以撤销</translation>
    </message>
    <message>
      <source>Whiskers × {gain}</source>
      <translation>偏差线 × {gain}</translation>
    </message>
    <message>
      <source>Width</source>
      <translation>宽度</translation>
    </message>
    <message>
      <source>Width of the strip of the surface that is measured</source>
      <translation>所测表面条带的宽度</translation>
    </message>
    <message>
      <source>Width of the zone</source>
      <translation>区域宽度</translation>
    </message>
    <message>
      <source>Worst verdict first</source>
      <translation>最差判定在前</translation>
    </message>
    <message>
      <source>Zoom to its features</source>
      <translation>缩放到其特征</translation>
    </message>
    <message>
      <source>alone</source>
      <translation>单独</translation>
    </message>
    <message>
      <source>an earlier version</source>
      <translation>早期版本</translation>
    </message>
    <message>
      <source>angle</source>
      <translation>角度</translation>
    </message>
    <message>
      <source>best fit</source>
      <translation>最佳拟合</translation>
    </message>
    <message>
      <source>blade section</source>
      <translation>叶片截面</translation>
    </message>
    <message>
      <source>circle</source>
      <translation>圆</translation>
    </message>
    <message>
      <source>cone</source>
      <translation>圆锥</translation>
    </message>
    <message>
      <source>coordinates</source>
      <translation>坐标</translation>
    </message>
    <message>
      <source>cylinder</source>
      <translation>圆柱</translation>
    </message>
    <message>
      <source>datums</source>
      <translation>基准</translation>
    </message>
    <message>
      <source>datums </source>
      <translation>基准</translation>
    </message>
    <message>
      <source>diameter {diameter}</source>
      <translation>直径 {diameter}</translation>
    </message>
    <message>
      <source>edge</source>
      <translation>边</translation>
    </message>
    <message>
      <source>evaluated by version {version} of MeasureApp</source>
      <translation>由 MeasureApp {version} 版评定</translation>
    </message>
    <message>
      <source>feature</source>
      <translation>个特征</translation>
    </message>
    <message>
      <source>features</source>
      <translation>个特征</translation>
    </message>
    <message>
      <source>fixes {fixed}</source>
      <translation>约束{fixed}</translation>
    </message>
    <message>
      <source>form {form}</source>
      <translation>形状误差 {form}</translation>
    </message>
    <message>
      <source>line</source>
      <translation>直线</translation>
    </message>
    <message>
      <source>maximum {value}</source>
      <translation>最大 {value}</translation>
    </message>
    <message>
      <source>none: no verdict</source>
      <translation>无：不作判定</translation>
    </message>
    <message>
      <source>not determined: {motion}</source>
      <translation>未确定：{motion}</translation>
    </message>
    <message>
      <source>plane</source>
      <translation>平面</translation>
    </message>
    <message>
      <source>point</source>
      <translation>点</translation>
    </message>
    <message>
      <source>points</source>
      <translation>个点</translation>
    </message>
    <message>
      <source>problem</source>
      <translation>个问题</translation>
    </message>
    <message>
      <source>reference points</source>
      <translation>参考点</translation>
    </message>
    <message>
      <source>slot</source>
      <translation>槽</translation>
    </message>
    <message>
      <source>sphere</source>
      <translation>球</translation>
    </message>
    <message>
      <source>strong</source>
      <translation>strong</translation>
    </message>
    <message>
      <source>to</source>
      <translation>至</translation>
    </message>
    <message>
      <source>torus</source>
      <translation>圆环</translation>
    </message>
    <message>
      <source>{chip}: show only these</source>
      <translation>{chip}：仅显示这些</translation>
    </message>
    <message>
      <source>{count} fail</source>
      <translation>{count} 个不合格</translation>
    </message>
    <message>
      <source>{count} not measured</source>
      <translation>{count} 个未测量</translation>
    </message>
    <message>
      <source>{count} not proven</source>
      <translation>{count} 个未证实</translation>
    </message>
    <message>
      <source>{count} of 6 degrees of freedom fixed</source>
      <translation>已确定 6 个自由度中的 {count} 个</translation>
    </message>
    <message>
      <source>{count} pass</source>
      <translation>{count} 个合格</translation>
    </message>
    <message>
      <source>{count} stale</source>
      <translation>{count} 过期</translation>
    </message>
    <message>
      <source>{count} without tolerance</source>
      <translation>{count} 无公差</translation>
    </message>
    <message>
      <source>{dimensions} duplicated.</source>
      <translation>已复制{dimensions}。</translation>
    </message>
    <message>
      <source>{filled}: {filled_2} of the surface</source>
      <translation>{filled}：表面的 {filled_2}</translation>
    </message>
    <message>
      <source>{inside} within the tolerance band, {below} below, {above} above.</source>
      <translation>公差带内 {inside}，低于 {below}，高于 {above}。</translation>
    </message>
    <message>
      <source>{kind}, width {millimetres}</source>
      <translation>{kind}，宽度 {millimetres}</translation>
    </message>
    <message>
      <source>{letter}  changes places with {name}</source>
      <translation>{letter}  与 {name} 互换</translation>
    </message>
    <message>
      <source>{listed}, each confirmed by its neighbours.</source>
      <translation>{listed}，均由其邻点证实。</translation>
    </message>
    <message>
      <source>{mark} Evaluated by another version of MeasureApp ({named}): its U may follow another error model than those beside it.</source>
      <translation>{mark} 由 MeasureApp 的其他版本（{named}）评定：其 U 依据的误差模型可能与其他行不同。</translation>
    </message>
    <message>
      <source>{names} and {count} more</source>
      <translation>{names} 及另外 {count} 个</translation>
    </message>
    <message>
      <source>{name} corrects no lengths any more.</source>
      <translation>{name} 不再修正其他长度。</translation>
    </message>
    <message>
      <source>{name} is datum {letter}.</source>
      <translation>{name} 现为基准 {letter}。</translation>
    </message>
    <message>
      <source>{name} is no datum.</source>
      <translation>{name} 不再是基准。</translation>
    </message>
    <message>
      <source>{name}: residual {off}.</source>
      <translation>{name}：残差 {off}。</translation>
    </message>
    <message>
      <source>{program}. Aligned by {name}, {rms_mm} rms.</source>
      <translation>{program}。按{name}对齐，均方根 {rms_mm}。</translation>
    </message>
    <message>
      <source>{program}. Not aligned: the part frame is taken as that of the nominal.</source>
      <translation>{program}。未对齐：以工件坐标系作为名义坐标系。</translation>
    </message>
    <message>
      <source>{shape_words}, constructed</source>
      <translation>{shape_words}，构造</translation>
    </message>
    <message>
      <source>{what} of {count} dimensions changed.</source>
      <translation>{count} 个尺寸的{what}已更改。</translation>
    </message>
    <message>
      <source>{what} of {name} changed.</source>
      <translation>{name} 的{what}已更改。</translation>
    </message>
  </context>
  <context>
    <name>look</name>
    <message>
      <source> or </source>
      <translation>或</translation>
    </message>
    <message>
      <source>-1: counts grow against the rig's positive direction</source>
      <translation>-1：计数沿测量系统的负方向增加</translation>
    </message>
    <message>
      <source>-1: counts grow clockwise seen from above; none: as the command table says</source>
      <translation>-1：从上方看，计数沿顺时针方向增加；未设置：按命令表</translation>
    </message>
    <message>
      <source>10 images: 4 steps at 16 px.</source>
      <translation>10 幅图像：16 px 处 4 步。</translation>
    </message>
    <message>
      <source>11 images: 4 steps at 16 px.</source>
      <translation>11 幅图像：16 px 处 4 步。</translation>
    </message>
    <message>
      <source>12 images: 4 steps at 16, 131.9 and 1088 px.</source>
      <translation>12 幅图像：16、131.9 和 1088 px 处 4 步。</translation>
    </message>
    <message>
      <source>12 images: 4 steps at 32, 186.6 and 1088 px.</source>
      <translation>12 幅图像：32、186.6 和 1088 px 处 4 步。</translation>
    </message>
    <message>
      <source>15 images: 8 steps at 16 px.</source>
      <translation>15 幅图像：16 px 处 8 步。</translation>
    </message>
    <message>
      <source>16 images: 4 steps at 32 and 33 px, both directions.</source>
      <translation>16 幅图像：32 和 33 px 处 4 步，两个方向。</translation>
    </message>
    <message>
      <source>16 images: 8 steps at 32 and 33 px.</source>
      <translation>16 幅图像：32 和 33 px 处 8 步。</translation>
    </message>
    <message>
      <source>16 images: 8, 4 and 4 steps at 16, 131.9 and 1088 px.</source>
      <translation>16 幅图像：16、131.9 和 1088 px 处 8、4、4 步。</translation>
    </message>
    <message>
      <source>1: exposures and read-outs last as long as in reality; 0: no waiting</source>
      <translation>1：曝光和读出的时长与实际相同；0：不等待</translation>
    </message>
    <message>
      <source>1: frames exposed in part show their most significant bit planes only; 0: all levels are even</source>
      <translation>1：部分曝光的帧只显示最高有效位平面；0：所有灰度级均匀</translation>
    </message>
    <message>
      <source>1: moves and exposures take as long as on a real rig; 0: no waiting</source>
      <translation>1：运动和曝光的时长与真实测量系统相同；0：不等待</translation>
    </message>
    <message>
      <source>22 images: 4 steps at 16 px, both directions.</source>
      <translation>22 幅图像：16 px 处 4 步，两个方向。</translation>
    </message>
    <message>
      <source>24 images: 4 steps at 16, 17.84 and 18.14 px, both directions.</source>
      <translation>24 幅图像：16、17.84 和 18.14 px 处 4 步，两个方向。</translation>
    </message>
    <message>
      <source>24 images: 8 steps at 16, 17.84 and 18.14 px.</source>
      <translation>24 幅图像：16、17.84 和 18.14 px 处 8 步。</translation>
    </message>
    <message>
      <source>28 images: 4 steps, each pitch half of the one before, from 17 px.</source>
      <translation>28 幅图像：4 步，间距从 17 px 起逐次减半。</translation>
    </message>
    <message>
      <source>32 and 33 px, 8 steps</source>
      <translation>32 和 33 px，8 步</translation>
    </message>
    <message>
      <source>8 images: 4 steps at 32 and 33 px.</source>
      <translation>8 幅图像：32 和 33 px 处 4 步。</translation>
    </message>
    <message>
      <source>9 images: 3 steps at 16, 17.84 and 18.14 px.</source>
      <translation>9 幅图像：16、17.84 和 18.14 px 处 3 步。</translation>
    </message>
    <message>
      <source>A command table of this plugin (newport_esp301, newport_smc100, owis_ps90, sigma_koki_shot), or the path of one</source>
      <translation>本插件的命令表（newport_esp301、newport_smc100、owis_ps90、sigma_koki_shot），或命令表文件的路径</translation>
    </message>
    <message>
      <source>A controller that does not answer for so long is lost</source>
      <translation>控制器超过此时间未应答即视为失联</translation>
    </message>
    <message>
      <source>A map of this plugin (toyo_xc100, iai_pcon, oriental_az, smc_lecp6, simple_axis), or the path of one</source>
      <translation>本插件的寄存器映射（toyo_xc100、iai_pcon、oriental_az、smc_lecp6、simple_axis），或映射文件的路径</translation>
    </message>
    <message>
      <source>A new sequence continues the recording, or restarts it</source>
      <translation>新的序列继续播放录制图像，或从头开始</translation>
    </message>
    <message>
      <source>A robot that does not answer for so long is lost</source>
      <translation>机器人超过此时间未应答即视为失联</translation>
    </message>
    <message>
      <source>ABB robot (Robot Web Services)</source>
      <translation>ABB 机器人 (Robot Web Services)</translation>
    </message>
    <message>
      <source>Absolute encoder</source>
      <translation>绝对编码器</translation>
    </message>
    <message>
      <source>Acceleration</source>
      <translation>加速度</translation>
    </message>
    <message>
      <source>Accuracy</source>
      <translation>精度</translation>
    </message>
    <message>
      <source>Accuracy of the orientation</source>
      <translation>姿态精度</translation>
    </message>
    <message>
      <source>Accuracy of the position</source>
      <translation>位置精度</translation>
    </message>
    <message>
      <source>Action</source>
      <translation>动作命令</translation>
    </message>
    <message>
      <source>Action1 (action command)</source>
      <translation>Action1（动作命令）</translation>
    </message>
    <message>
      <source>Additional blur 100 mm from the plane in focus, likewise</source>
      <translation>离焦平面 100 mm 处的附加模糊，全分辨率下的标准差</translation>
    </message>
    <message>
      <source>Additional blur in the corners, standard deviation at full resolution</source>
      <translation>图像四角的附加模糊，全分辨率下的标准差</translation>
    </message>
    <message>
      <source>Additional blur of the part, not of the board, likewise</source>
      <translation>工件（而非标定板）的附加模糊，全分辨率下的标准差</translation>
    </message>
    <message>
      <source>Address</source>
      <translation>地址</translation>
    </message>
    <message>
      <source>Address host:port of a virtual cell in another program, whose axes move this rig; empty: none</source>
      <translation>另一程序中虚拟工作站的地址 host:port，其各轴驱动本测量系统；留空：无</translation>
    </message>
    <message>
      <source>Address of a device or gateway on TCP; then no port</source>
      <translation>TCP 设备或网关的地址；此时不填串口</translation>
    </message>
    <message>
      <source>Address with http:// or https://, without a path</source>
      <translation>以 http:// 或 https:// 开头的地址，不含路径</translation>
    </message>
    <message>
      <source>After the last image</source>
      <translation>最后一幅图像之后</translation>
    </message>
    <message>
      <source>After the last image of an exposure: begin again, or refuse triggers</source>
      <translation>某一曝光的最后一幅图像之后：重新开始，或拒绝触发</translation>
    </message>
    <message>
      <source>After this time without an answer the camera counts as lost</source>
      <translation>相机超过此时间未应答即视为失联</translation>
    </message>
    <message>
      <source>All {count} pass.</source>
      <translation>全部 {count}合格。</translation>
    </message>
    <message>
      <source>Also a part of file names</source>
      <translation>也用于文件名</translation>
    </message>
    <message>
      <source>Ambient</source>
      <translation>环境光</translation>
    </message>
    <message>
      <source>Ambient flicker</source>
      <translation>环境光闪烁</translation>
    </message>
    <message>
      <source>Ambient light</source>
      <translation>环境光</translation>
    </message>
    <message>
      <source>Ambiguous</source>
      <translation>多义</translation>
    </message>
    <message>
      <source>Angle tolerance</source>
      <translation>角度容差</translation>
    </message>
    <message>
      <source>Angular acceleration</source>
      <translation>角加速度</translation>
    </message>
    <message>
      <source>Angular error</source>
      <translation>角度误差</translation>
    </message>
    <message>
      <source>Arm</source>
      <translation>机械臂</translation>
    </message>
    <message>
      <source>As the map says</source>
      <translation>按映射</translation>
    </message>
    <message>
      <source>At a new sequence</source>
      <translation>新序列开始时</translation>
    </message>
    <message>
      <source>At rest: two orientations read back differ less</source>
      <translation>静止：两次读回的姿态之差小于此值</translation>
    </message>
    <message>
      <source>At rest: two positions read back differ less</source>
      <translation>静止：两次读回的位置之差小于此值</translation>
    </message>
    <message>
      <source>At rest: two read-backs of every joint differ less</source>
      <translation>静止：每个关节两次读回之差小于此值</translation>
    </message>
    <message>
      <source>At the goal: every joint differs less</source>
      <translation>到达目标：每个关节的偏差小于此值</translation>
    </message>
    <message>
      <source>At the goal: the orientation differs less</source>
      <translation>到达目标：姿态偏差小于此值</translation>
    </message>
    <message>
      <source>At the goal: the position differs less</source>
      <translation>到达目标：位置偏差小于此值</translation>
    </message>
    <message>
      <source>At which a scan drives; none: a usual one</source>
      <translation>扫描时采用的值；未设置：常用值</translation>
    </message>
    <message>
      <source>Automatic</source>
      <translation>自动</translation>
    </message>
    <message>
      <source>Automatic: the most compact format with the bit depth of the rig description</source>
      <translation>自动：与测量系统描述中位深相符的最紧凑格式</translation>
    </message>
    <message>
      <source>Axes on Modbus: TOYO, IAI, Oriental Motor, SMC</source>
      <translation>Modbus 轴：TOYO、IAI、Oriental Motor、SMC</translation>
    </message>
    <message>
      <source>Axial error motion</source>
      <translation>轴向误差运动</translation>
    </message>
    <message>
      <source>Axial error motion of the table, half its range</source>
      <translation>转台的轴向误差运动，范围的一半</translation>
    </message>
    <message>
      <source>Axial error motion, ±; none: a usual one</source>
      <translation>轴向误差运动，±；未设置：常用值</translation>
    </message>
    <message>
      <source>Axis</source>
      <translation>轴</translation>
    </message>
    <message>
      <source>Basler camera (pylon)</source>
      <translation>Basler 相机 (pylon)</translation>
    </message>
    <message>
      <source>Baud rate</source>
      <translation>波特率</translation>
    </message>
    <message>
      <source>Beam of the guide</source>
      <translation>导轨横梁</translation>
    </message>
    <message>
      <source>Begin again</source>
      <translation>重新开始</translation>
    </message>
    <message>
      <source>Bit depth</source>
      <translation>位深</translation>
    </message>
    <message>
      <source>Bit planes</source>
      <translation>位平面</translation>
    </message>
    <message>
      <source>Black</source>
      <translation>黑电平</translation>
    </message>
    <message>
      <source>Black level</source>
      <translation>黑电平</translation>
    </message>
    <message>
      <source>Black level of the projector relative to white</source>
      <translation>投影仪黑电平与白电平之比</translation>
    </message>
    <message>
      <source>Blade form</source>
      <translation>叶片形状误差</translation>
    </message>
    <message>
      <source>Blade profile</source>
      <translation>叶片轮廓度</translation>
    </message>
    <message>
      <source>Blooming</source>
      <translation>溢出</translation>
    </message>
    <message>
      <source>Blue</source>
      <translation>蓝</translation>
    </message>
    <message>
      <source>Blur of the camera image, standard deviation in camera pixels</source>
      <translation>相机图像的模糊，以相机像素为单位的标准差</translation>
    </message>
    <message>
      <source>Blur of the projected image, standard deviation in projector pixels</source>
      <translation>投影图像的模糊，以投影仪像素为单位的标准差</translation>
    </message>
    <message>
      <source>Board bow</source>
      <translation>标定板弯曲</translation>
    </message>
    <message>
      <source>Board excess</source>
      <translation>标定板温升</translation>
    </message>
    <message>
      <source>Bodies in the cell</source>
      <translation>工作站中的物体</translation>
    </message>
    <message>
      <source>Bounce</source>
      <translation>二次反射</translation>
    </message>
    <message>
      <source>Box</source>
      <translation>盒</translation>
    </message>
    <message>
      <source>Boxes of the head</source>
      <translation>测头的外形盒</translation>
    </message>
    <message>
      <source>Buffers</source>
      <translation>缓冲区数</translation>
    </message>
    <message>
      <source>By how much the board is warmer than 20 °C; expansion 9 ppm/K</source>
      <translation>标定板高于 20 °C 的温度；膨胀系数 9 ppm/K</translation>
    </message>
    <message>
      <source>By how much the part is warmer than 20 °C; expansion 11.5 ppm/K</source>
      <translation>工件高于 20 °C 的温度；膨胀系数 11.5 ppm/K</translation>
    </message>
    <message>
      <source>By which the clock of the warm-up moves with every image of the head</source>
      <translation>测头每拍摄一幅图像，预热时钟前进的时间</translation>
    </message>
    <message>
      <source>Calibration</source>
      <translation>标定</translation>
    </message>
    <message>
      <source>Calibration images</source>
      <translation>标定图像</translation>
    </message>
    <message>
      <source>Camber</source>
      <translation>弯度</translation>
    </message>
    <message>
      <source>Camera drift</source>
      <translation>相机漂移</translation>
    </message>
    <message>
      <source>Camera in the head</source>
      <translation>测头中的相机</translation>
    </message>
    <message>
      <source>Camera of recorded images</source>
      <translation>录制图像的相机</translation>
    </message>
    <message>
      <source>Camera shift</source>
      <translation>相机平移</translation>
    </message>
    <message>
      <source>Camera turn</source>
      <translation>相机转动</translation>
    </message>
    <message>
      <source>Cameras</source>
      <translation>相机</translation>
    </message>
    <message>
      <source>Cameras displaced after calibration: name and rotation vector in the camera's own frame</source>
      <translation>标定后被碰动的相机：名称及其在自身坐标系中的旋转矢量</translation>
    </message>
    <message>
      <source>Cameras on link</source>
      <translation>同一链路上的相机</translation>
    </message>
    <message>
      <source>Cameras that send their images over the same link</source>
      <translation>通过同一链路传输图像的相机数</translation>
    </message>
    <message>
      <source>Cantarell</source>
      <translation>Cantarell</translation>
    </message>
    <message>
      <source>Centre in the guide frame</source>
      <translation>导轨坐标系中的中心</translation>
    </message>
    <message>
      <source>Certificate</source>
      <translation>证书</translation>
    </message>
    <message>
      <source>Certificate SHA-256</source>
      <translation>证书 SHA-256</translation>
    </message>
    <message>
      <source>Certified length at 20 °C</source>
      <translation>20 °C 时的证书长度</translation>
    </message>
    <message>
      <source>Change of the ambient light from image to image, standard deviation</source>
      <translation>图像之间环境光的变化，标准差</translation>
    </message>
    <message>
      <source>Change of the head's temperature since the calibration</source>
      <translation>自标定以来测头的温度变化</translation>
    </message>
    <message>
      <source>Checks</source>
      <translation>检查</translation>
    </message>
    <message>
      <source>Choose one of: {expected}</source>
      <translation>请选择其一：{expected}</translation>
    </message>
    <message>
      <source>Chord</source>
      <translation>弦长</translation>
    </message>
    <message>
      <source>Clearance</source>
      <translation>间隙</translation>
    </message>
    <message>
      <source>Clouds</source>
      <translation>点云</translation>
    </message>
    <message>
      <source>Column and row of the image's first pixel on the sensor</source>
      <translation>图像第一个像素在传感器上的列和行</translation>
    </message>
    <message>
      <source>Coma</source>
      <translation>彗差</translation>
    </message>
    <message>
      <source>Complem. Gray, 8 steps</source>
      <translation>互补格雷码，8 步</translation>
    </message>
    <message>
      <source>Complem. Gray, orthogonal</source>
      <translation>互补格雷码，正交</translation>
    </message>
    <message>
      <source>Complementary Gray</source>
      <translation>互补格雷码</translation>
    </message>
    <message>
      <source>Conditions</source>
      <translation>状况</translation>
    </message>
    <message>
      <source>Connection refused</source>
      <translation>连接被拒绝</translation>
    </message>
    <message>
      <source>Connection reset by peer</source>
      <translation>连接被对方重置</translation>
    </message>
    <message>
      <source>Continue</source>
      <translation>继续</translation>
    </message>
    <message>
      <source>Contradicted</source>
      <translation>矛盾</translation>
    </message>
    <message>
      <source>Controller</source>
      <translation>控制器</translation>
    </message>
    <message>
      <source>Corner blur</source>
      <translation>四角模糊</translation>
    </message>
    <message>
      <source>Counts at position 0 of the rig</source>
      <translation>测量系统位置 0 处的计数</translation>
    </message>
    <message>
      <source>Counts at zero</source>
      <translation>零点计数</translation>
    </message>
    <message>
      <source>Counts per degree; none: as the command table says</source>
      <translation>每度的计数；未设置：按命令表</translation>
    </message>
    <message>
      <source>Counts per mm or degree; none: as the drive's map says</source>
      <translation>每毫米或每度的计数；未设置：按驱动器映射</translation>
    </message>
    <message>
      <source>Counts per unit</source>
      <translation>每单位计数</translation>
    </message>
    <message>
      <source>Creep of the flange after every move, in a random direction</source>
      <translation>法兰每次运动后沿随机方向的蠕动</translation>
    </message>
    <message>
      <source>Current of the LEDs in use, 1…255; 0: as the projector is set</source>
      <translation>所用 LED 的电流，1…255；0：按投影仪的设置</translation>
    </message>
    <message>
      <source>Curvature</source>
      <translation>非线性</translation>
    </message>
    <message>
      <source>Cycle of a held pattern</source>
      <translation>保持图案的周期</translation>
    </message>
    <message>
      <source>Cylinder</source>
      <translation>圆柱</translation>
    </message>
    <message>
      <source>Cylinder: the upright one that just fits into the box</source>
      <translation>圆柱：恰好内接于该长方体的直立圆柱</translation>
    </message>
    <message>
      <source>Dark signal non-uniformity in electrons, standard deviation (EMVA 1288)</source>
      <translation>暗信号非均匀性，以电子数为单位的标准差 (EMVA 1288)</translation>
    </message>
    <message>
      <source>Dark spread</source>
      <translation>暗信号非均匀性</translation>
    </message>
    <message>
      <source>Defocus</source>
      <translation>离焦</translation>
    </message>
    <message>
      <source>Delay between packets</source>
      <translation>数据包间隔</translation>
    </message>
    <message>
      <source>Delay of each camera's trigger, standard deviation; never early</source>
      <translation>各相机触发的延迟，标准差；不会提前</translation>
    </message>
    <message>
      <source>Demo: {name}, {resolution} resolution, {count} views, seed {seed}</source>
      <translation>演示：{name}，{resolution}分辨率，{count} 个视图，种子 {seed}</translation>
    </message>
    <message>
      <source>Demo: {name}, {resolution} resolution, {count} views, seed {seed}, {world} rig</source>
      <translation>演示：{name}，{resolution}分辨率，{count} 个视图，种子 {seed}，{world}测量系统</translation>
    </message>
    <message>
      <source>Depth discontinuity</source>
      <translation>深度不连续</translation>
    </message>
    <message>
      <source>Deviation from the kinematic model</source>
      <translation>与运动学模型的偏差</translation>
    </message>
    <message>
      <source>Device key</source>
      <translation>设备密钥</translation>
    </message>
    <message>
      <source>Devices</source>
      <translation>设备</translation>
    </message>
    <message>
      <source>Displacement at the image's edge 80 mm from focus, against which no distortion at one depth helps</source>
      <translation>离焦平面 80 mm 处图像边缘的位移，单一深度的畸变模型无法校正</translation>
    </message>
    <message>
      <source>Displacement of the flange since the calibration by warming up, largest; none: not counted</source>
      <translation>自标定以来法兰因升温产生的最大位移；未设置：不计入</translation>
    </message>
    <message>
      <source>Displacement of the flange until the robot is warm</source>
      <translation>机器人达到热稳定之前法兰的位移</translation>
    </message>
    <message>
      <source>Displacement of the image until the projector is warm, at full resolution</source>
      <translation>投影仪达到热稳定之前图像的位移，按全分辨率</translation>
    </message>
    <message>
      <source>Displacement of the principal point until the cameras are warm, full resolution</source>
      <translation>相机达到热稳定之前主点的位移，按全分辨率</translation>
    </message>
    <message>
      <source>Distance of the measuring volume from the reference camera</source>
      <translation>测量体积到参考相机的距离</translation>
    </message>
    <message>
      <source>Distance that every joint keeps from its limits</source>
      <translation>每个关节与其极限保持的距离</translation>
    </message>
    <message>
      <source>Distortion that the lens model lacks, rms per axis at full resolution</source>
      <translation>镜头模型未包含的畸变，全分辨率下每轴的均方根值</translation>
    </message>
    <message>
      <source>Distortion {name}</source>
      <translation>畸变 {name}</translation>
    </message>
    <message>
      <source>Drift</source>
      <translation>漂移</translation>
    </message>
    <message>
      <source>Drive</source>
      <translation>驱动器</translation>
    </message>
    <message>
      <source>Driver settings</source>
      <translation>驱动设置</translation>
    </message>
    <message>
      <source>Driver that shows images at its video port (source video)</source>
      <translation>在其视频端口显示图像的驱动（图案来源为视频端口时）</translation>
    </message>
    <message>
      <source>Duration of a frame</source>
      <translation>一帧的时长</translation>
    </message>
    <message>
      <source>Duration of a frame of the projector</source>
      <translation>投影仪一帧的时长</translation>
    </message>
    <message>
      <source>Duration of one cycle of the bit planes while a pattern is held; exposures are whole multiples of it</source>
      <translation>保持图案时位平面一个周期的时长；曝光时间为其整数倍</translation>
    </message>
    <message>
      <source>Duration of the read-out after each exposure</source>
      <translation>每次曝光后读出的时长</translation>
    </message>
    <message>
      <source>Duration over which the projector's grey levels are right; 0: one frame of the screen</source>
      <translation>投影仪灰度级准确所需的时长；0：屏幕的一帧</translation>
    </message>
    <message>
      <source>EGM port</source>
      <translation>EGM 端口</translation>
    </message>
    <message>
      <source>Edge</source>
      <translation>棱边</translation>
    </message>
    <message>
      <source>Edges</source>
      <translation>棱边</translation>
    </message>
    <message>
      <source>Electrons at full scale</source>
      <translation>满量程时的电子数</translation>
    </message>
    <message>
      <source>Enter a finite number</source>
      <translation>请输入有限数值</translation>
    </message>
    <message>
      <source>Enter a number</source>
      <translation>请输入数字</translation>
    </message>
    <message>
      <source>Enter a value</source>
      <translation>请输入数值</translation>
    </message>
    <message>
      <source>Enter a value.</source>
      <translation>请输入数值。</translation>
    </message>
    <message>
      <source>Enter a whole number</source>
      <translation>请输入整数</translation>
    </message>
    <message>
      <source>Error of scale, drawn for x and y with half of it in common</source>
      <translation>尺度误差，x 和 y 分别抽取，其中一半为共有</translation>
    </message>
    <message>
      <source>Errors</source>
      <translation>误差</translation>
    </message>
    <message>
      <source>Even parity</source>
      <translation>偶校验</translation>
    </message>
    <message>
      <source>Expanded uncertainty (k = 2) of the length</source>
      <translation>长度的扩展不确定度 (k = 2)</translation>
    </message>
    <message>
      <source>Exposure chunk</source>
      <translation>图像附带曝光数据</translation>
    </message>
    <message>
      <source>Exposure in the name</source>
      <translation>名称中的曝光</translation>
    </message>
    <message>
      <source>FAIL</source>
      <translation>不合格</translation>
    </message>
    <message>
      <source>Field required</source>
      <translation>缺少此字段</translation>
    </message>
    <message>
      <source>File</source>
      <translation>文件</translation>
    </message>
    <message>
      <source>File is not a zip file</source>
      <translation>文件不是 zip 文件</translation>
    </message>
    <message>
      <source>Files</source>
      <translation>文件</translation>
    </message>
    <message>
      <source>Fingerprint of the controller's own certificate, for https; empty: one that this computer trusts</source>
      <translation>控制器自有证书的指纹，用于 https；留空：本计算机信任的证书</translation>
    </message>
    <message>
      <source>First column read out</source>
      <translation>读出的第一列</translation>
    </message>
    <message>
      <source>First row read out</source>
      <translation>读出的第一行</translation>
    </message>
    <message>
      <source>Fixture</source>
      <translation>夹具</translation>
    </message>
    <message>
      <source>Fixtures</source>
      <translation>夹具</translation>
    </message>
    <message>
      <source>Flash</source>
      <translation>闪存</translation>
    </message>
    <message>
      <source>Flash memory</source>
      <translation>闪存</translation>
    </message>
    <message>
      <source>Flat</source>
      <translation>平板</translation>
    </message>
    <message>
      <source>Flat: flatness of the top</source>
      <translation>平板：顶面平面度</translation>
    </message>
    <message>
      <source>Flying point</source>
      <translation>飞点</translation>
    </message>
    <message>
      <source>Focal drift</source>
      <translation>焦距漂移</translation>
    </message>
    <message>
      <source>Focal length</source>
      <translation>焦距</translation>
    </message>
    <message>
      <source>Folder</source>
      <translation>文件夹</translation>
    </message>
    <message>
      <source>Follows the cell at</source>
      <translation>跟随的工作站</translation>
    </message>
    <message>
      <source>For controllers that cannot report whether they are referenced: true where the position is known after power-up</source>
      <translation>用于无法报告是否已回零的控制器：上电后位置已知时为“是”</translation>
    </message>
    <message>
      <source>For drives that cannot report whether they are referenced: true where the position is known after power-up</source>
      <translation>用于无法报告是否已回零的驱动器：上电后位置已知时为“是”</translation>
    </message>
    <message>
      <source>For messages, such as the name of the pattern set</source>
      <translation>用于消息，例如图案集的名称</translation>
    </message>
    <message>
      <source>For {area} mm²: {cause}.</source>
      <translation>用于 {area} mm²：{cause}。</translation>
    </message>
    <message>
      <source>Framing</source>
      <translation>帧格式</translation>
    </message>
    <message>
      <source>From painting an image until it is lit for certain; `measureapp rig latency` measures it</source>
      <translation>从绘制图像到确定已投射的时间；可用 `measureapp rig latency` 测量</translation>
    </message>
    <message>
      <source>Full well</source>
      <translation>满阱容量</translation>
    </message>
    <message>
      <source>Further straightness error of the guide, half its range</source>
      <translation>导轨的其他直线度误差，范围的一半</translation>
    </message>
    <message>
      <source>Fusion</source>
      <translation>融合</translation>
    </message>
    <message>
      <source>Gain</source>
      <translation>增益</translation>
    </message>
    <message>
      <source>Gain spread</source>
      <translation>光响应非均匀性</translation>
    </message>
    <message>
      <source>Gamma</source>
      <translation>伽马</translation>
    </message>
    <message>
      <source>Gear</source>
      <translation>齿轮</translation>
    </message>
    <message>
      <source>Gear: diameters and boss</source>
      <translation>齿轮：直径与凸台</translation>
    </message>
    <message>
      <source>Gear: form, orientation, location and run-out</source>
      <translation>齿轮：形状、方向、位置与跳动</translation>
    </message>
    <message>
      <source>GenICam camera (GigE Vision, USB3 Vision)</source>
      <translation>GenICam 相机 (GigE Vision、USB3 Vision)</translation>
    </message>
    <message>
      <source>GigE 1000, 5GigE 5000, USB3 about 3200</source>
      <translation>GigE 为 1000，5GigE 为 5000，USB3 约为 3200</translation>
    </message>
    <message>
      <source>GigE Vision, pause between packets; none: leave it as it is</source>
      <translation>GigE Vision 数据包之间的间隔；未设置：保持不变</translation>
    </message>
    <message>
      <source>GigE Vision; none: the largest that arrives</source>
      <translation>GigE Vision 数据包大小；未设置：能够到达的最大值</translation>
    </message>
    <message>
      <source>Give at least {limits}.</source>
      <translation>请至少给出 {limits}。</translation>
    </message>
    <message>
      <source>Glare</source>
      <translation>眩光</translation>
    </message>
    <message>
      <source>Global reset</source>
      <translation>全局复位</translation>
    </message>
    <message>
      <source>Global shutter</source>
      <translation>全局快门</translation>
    </message>
    <message>
      <source>Gray code</source>
      <translation>格雷码</translation>
    </message>
    <message>
      <source>Grazing incidence</source>
      <translation>掠入射</translation>
    </message>
    <message>
      <source>Green</source>
      <translation>绿</translation>
    </message>
    <message>
      <source>Grey level of uniform light</source>
      <translation>均匀光的灰度级</translation>
    </message>
    <message>
      <source>Group key</source>
      <translation>组密钥</translation>
    </message>
    <message>
      <source>Group mask</source>
      <translation>组掩码</translation>
    </message>
    <message>
      <source>Guide angle</source>
      <translation>导轨角度误差</translation>
    </message>
    <message>
      <source>Guide backlash</source>
      <translation>导轨反向间隙</translation>
    </message>
    <message>
      <source>Guide straightness</source>
      <translation>导轨直线度</translation>
    </message>
    <message>
      <source>Gypsum</source>
      <translation>石膏</translation>
    </message>
    <message>
      <source>Gypsum cross: a, b, c, d</source>
      <translation>石膏十字：a、b、c、d</translation>
    </message>
    <message>
      <source>Hand eye shift</source>
      <translation>手眼平移</translation>
    </message>
    <message>
      <source>Hand eye turn</source>
      <translation>手眼转动</translation>
    </message>
    <message>
      <source>Hardware</source>
      <translation>硬件</translation>
    </message>
    <message>
      <source>Hardware trigger</source>
      <translation>硬件触发</translation>
    </message>
    <message>
      <source>Hash</source>
      <translation>散列值</translation>
    </message>
    <message>
      <source>Head lamp, on while no pattern is shown</source>
      <translation>测头照明灯，不投射图案时点亮</translation>
    </message>
    <message>
      <source>Head on the flange</source>
      <translation>法兰上的测头</translation>
    </message>
    <message>
      <source>Height of the board's centre above its border</source>
      <translation>标定板中心高出边缘的高度</translation>
    </message>
    <message>
      <source>Height of the floor</source>
      <translation>地面高度</translation>
    </message>
    <message>
      <source>Height of the floor in the guide frame; default: the plane on which the robot stands</source>
      <translation>地面在导轨坐标系中的高度；默认：机器人安装平面</translation>
    </message>
    <message>
      <source>Hierarchical</source>
      <translation>分层</translation>
    </message>
    <message>
      <source>Host</source>
      <translation>主机</translation>
    </message>
    <message>
      <source>Hot</source>
      <translation>热像素</translation>
    </message>
    <message>
      <source>How long a camera that another program holds is tried again</source>
      <translation>相机被其他程序占用时重试的时间</translation>
    </message>
    <message>
      <source>How long to try while another program controls the camera; longer than its heartbeat, 3 s</source>
      <translation>其他程序控制相机时重试的时间；应长于其心跳时间 3 s</translation>
    </message>
    <message>
      <source>How messages are framed on the line</source>
      <translation>线路上报文的帧格式</translation>
    </message>
    <message>
      <source>How well rig and part are made: ideal, good, usual, bad or a TOML file of a world; a table [world] takes its place</source>
      <translation>测量系统和工件的制造水平：ideal、good、usual、bad，或虚拟环境的 TOML 文件；有 [world] 表时以该表为准</translation>
    </message>
    <message>
      <source>ID of the controller's system; empty: any</source>
      <translation>控制器系统的 ID；留空：任意</translation>
    </message>
    <message>
      <source>ID of the plugin</source>
      <translation>插件的 ID</translation>
    </message>
    <message>
      <source>ID of the plugin that drives the whole rig</source>
      <translation>驱动整个测量系统的插件的 ID</translation>
    </message>
    <message>
      <source>Identity of the set, as the driver states it when it does not know the set</source>
      <translation>图案集的标识，即驱动不认识该图案集时给出的标识</translation>
    </message>
    <message>
      <source>Image height</source>
      <translation>图像高度</translation>
    </message>
    <message>
      <source>Image width</source>
      <translation>图像宽度</translation>
    </message>
    <message>
      <source>Images that can wait for being read</source>
      <translation>可等待读取的图像数</translation>
    </message>
    <message>
      <source>Images that the computer holds until they are fetched</source>
      <translation>计算机在取走之前缓存的图像数</translation>
    </message>
    <message>
      <source>Impeller</source>
      <translation>叶轮</translation>
    </message>
    <message>
      <source>Impeller: blades</source>
      <translation>叶轮：叶片</translation>
    </message>
    <message>
      <source>Impeller: diameters and blades</source>
      <translation>叶轮：直径与叶片</translation>
    </message>
    <message>
      <source>In degrees per second squared; for the predicted duration</source>
      <translation>单位为度每二次方秒；用于预测时长</translation>
    </message>
    <message>
      <source>In mm or degrees per second squared; for the predicted duration</source>
      <translation>单位为毫米或度每二次方秒；用于预测时长</translation>
    </message>
    <message>
      <source>In the camera's own unit (Gain: dB, GainRaw: counts); none: leave it as it is</source>
      <translation>采用相机自身的单位（Gain：dB，GainRaw：计数）；未设置：保持不变</translation>
    </message>
    <message>
      <source>In the camera's unit (raw steps on ace GigE, dB on newer ones); none: the lowest</source>
      <translation>采用相机的单位（ace GigE 为原始步数，较新型号为 dB）；未设置：最低值</translation>
    </message>
    <message>
      <source>In the camera's unit; none: as in its default user set</source>
      <translation>采用相机的单位；未设置：按其默认用户设置集</translation>
    </message>
    <message>
      <source>In the head frame; none given: derived from cameras and projector</source>
      <translation>在测头坐标系中；未给出时由相机和投影仪推导</translation>
    </message>
    <message>
      <source>In ticks; none: shared equally by the cameras of the link</source>
      <translation>以时钟周期为单位；未设置：由链路上的相机平均分配</translation>
    </message>
    <message>
      <source>Input of the hardware trigger, rising edge</source>
      <translation>硬件触发的输入端，上升沿</translation>
    </message>
    <message>
      <source>Input should be a finite number</source>
      <translation>应为有限数</translation>
    </message>
    <message>
      <source>Input should be a valid boolean</source>
      <translation>应为 true 或 false</translation>
    </message>
    <message>
      <source>Input should be a valid dictionary</source>
      <translation>应为表</translation>
    </message>
    <message>
      <source>Input should be a valid dictionary or instance of {model}</source>
      <translation>应为表或 {model}</translation>
    </message>
    <message>
      <source>Input should be a valid integer</source>
      <translation>应为整数</translation>
    </message>
    <message>
      <source>Input should be a valid integer, got a number with a fractional part</source>
      <translation>应为整数，而非带小数的数</translation>
    </message>
    <message>
      <source>Input should be a valid integer, unable to parse string as an integer</source>
      <translation>应为整数，此文本不是整数</translation>
    </message>
    <message>
      <source>Input should be a valid list</source>
      <translation>应为列表</translation>
    </message>
    <message>
      <source>Input should be a valid number</source>
      <translation>应为数字</translation>
    </message>
    <message>
      <source>Input should be a valid number, unable to parse string as a number</source>
      <translation>应为数字，此文本不是数字</translation>
    </message>
    <message>
      <source>Input should be a valid string</source>
      <translation>应为文本</translation>
    </message>
    <message>
      <source>Input should be a valid tuple</source>
      <translation>应为数组</translation>
    </message>
    <message>
      <source>Input should be greater than or equal to {limit}</source>
      <translation>应不小于 {limit}</translation>
    </message>
    <message>
      <source>Input should be greater than {limit}</source>
      <translation>应大于 {limit}</translation>
    </message>
    <message>
      <source>Input should be less than or equal to {limit}</source>
      <translation>应不大于 {limit}</translation>
    </message>
    <message>
      <source>Input should be less than {limit}</source>
      <translation>应小于 {limit}</translation>
    </message>
    <message>
      <source>Input should be {expected}</source>
      <translation>应为 {expected}</translation>
    </message>
    <message>
      <source>Input/output error</source>
      <translation>输入/输出错误</translation>
    </message>
    <message>
      <source>Inspection</source>
      <translation>检测</translation>
    </message>
    <message>
      <source>Inter</source>
      <translation>Inter</translation>
    </message>
    <message>
      <source>Interval of polls while the robot moves</source>
      <translation>机器人运动时的轮询间隔</translation>
    </message>
    <message>
      <source>Interval of reads at rest</source>
      <translation>静止时的读数间隔</translation>
    </message>
    <message>
      <source>Interval of reads in motion</source>
      <translation>运动时的读数间隔</translation>
    </message>
    <message>
      <source>Inverse camera in the bundle adjustment of all cameras</source>
      <translation>在所有相机的光束法平差中作为逆相机</translation>
    </message>
    <message>
      <source>Is a directory</source>
      <translation>是文件夹</translation>
    </message>
    <message>
      <source>Isolated patch</source>
      <translation>孤立碎片</translation>
    </message>
    <message>
      <source>Joining</source>
      <translation>拼合</translation>
    </message>
    <message>
      <source>Joint calibration of the rig</source>
      <translation>测量系统联合标定</translation>
    </message>
    <message>
      <source>Joint margin</source>
      <translation>关节余量</translation>
    </message>
    <message>
      <source>Joint refinement</source>
      <translation>联合优化</translation>
    </message>
    <message>
      <source>Keep-out boxes</source>
      <translation>禁入区</translation>
    </message>
    <message>
      <source>Keys of the action command, for the trigger source Action1</source>
      <translation>动作命令的密钥，用于触发源 Action1</translation>
    </message>
    <message>
      <source>Kinematic model</source>
      <translation>运动学模型</translation>
    </message>
    <message>
      <source>Kinematic model: a name in `resources/robots`, a TOML file of the same form, or a URDF with a link `tool0`</source>
      <translation>运动学模型：`resources/robots` 中的名称、相同格式的 TOML 文件，或含连杆 `tool0` 的 URDF</translation>
    </message>
    <message>
      <source>Kinematic model: a name in `resources/robots`, or the path of a TOML or URDF file; empty: reach only</source>
      <translation>运动学模型：`resources/robots` 中的名称，或 TOML 或 URDF 文件的路径；留空：只考虑工作半径</translation>
    </message>
    <message>
      <source>Knocked</source>
      <translation>被碰动的相机</translation>
    </message>
    <message>
      <source>LED</source>
      <translation>LED</translation>
    </message>
    <message>
      <source>LED current</source>
      <translation>LED 电流</translation>
    </message>
    <message>
      <source>Lamp</source>
      <translation>照明灯</translation>
    </message>
    <message>
      <source>Largest change of temperature</source>
      <translation>最大温度变化</translation>
    </message>
    <message>
      <source>Largest deviation of the response from a straight line, of full scale</source>
      <translation>响应偏离直线的最大值，相对于满量程</translation>
    </message>
    <message>
      <source>Largest diameter of a part about the table's axis; none: the table's</source>
      <translation>工件绕转台轴线的最大直径；未设置：转台直径</translation>
    </message>
    <message>
      <source>Largest difference of goal and read-back, in degrees</source>
      <translation>目标与读回的最大差值，单位为度</translation>
    </message>
    <message>
      <source>Largest difference of goal and read-back, in mm or degrees</source>
      <translation>目标与读回的最大差值，单位为毫米或度</translation>
    </message>
    <message>
      <source>Largest difference of read-back and goal, robot and guide</source>
      <translation>读回与目标的最大差值，用于机器人和导轨</translation>
    </message>
    <message>
      <source>Largest difference of read-back and goal, robot and table</source>
      <translation>读回与目标的最大差值，用于机器人和转台</translation>
    </message>
    <message>
      <source>Largest difference of the controller's pose and the kinematic model's</source>
      <translation>控制器的位姿与运动学模型的位姿之间的最大差值</translation>
    </message>
    <message>
      <source>Largest part</source>
      <translation>最大工件</translation>
    </message>
    <message>
      <source>Largest reach</source>
      <translation>最大工作半径</translation>
    </message>
    <message>
      <source>Largest speeds of the joints; none: those of the kinematic model</source>
      <translation>各关节的最大速度；未设置：取运动学模型的值</translation>
    </message>
    <message>
      <source>Late</source>
      <translation>触发延迟</translation>
    </message>
    <message>
      <source>Latency</source>
      <translation>延迟</translation>
    </message>
    <message>
      <source>Leading radius</source>
      <translation>前缘半径</translation>
    </message>
    <message>
      <source>Least distance that moving bodies keep from everything else</source>
      <translation>运动物体与其他一切物体保持的最小距离</translation>
    </message>
    <message>
      <source>Least reach</source>
      <translation>最小工作半径</translation>
    </message>
    <message>
      <source>Lens blur</source>
      <translation>镜头模糊</translation>
    </message>
    <message>
      <source>Lenses</source>
      <translation>镜头</translation>
    </message>
    <message>
      <source>Let each image carry its exposure, where the camera can; it is then checked</source>
      <translation>相机支持时让每幅图像附带其曝光时间，并进行核对</translation>
    </message>
    <message>
      <source>Level spread</source>
      <translation>光强波动</translation>
    </message>
    <message>
      <source>Light from one image to the next, relative standard deviation</source>
      <translation>图像之间的光强变化，相对标准差</translation>
    </message>
    <message>
      <source>Light of all patterns</source>
      <translation>所有图案的光色</translation>
    </message>
    <message>
      <source>Line1 (trigger input)</source>
      <translation>Line1（触发输入）</translation>
    </message>
    <message>
      <source>Line2 (trigger input)</source>
      <translation>Line2（触发输入）</translation>
    </message>
    <message>
      <source>Line3 (trigger input)</source>
      <translation>Line3（触发输入）</translation>
    </message>
    <message>
      <source>Link</source>
      <translation>连接</translation>
    </message>
    <message>
      <source>List should have at least {count} items after validation, not {found}</source>
      <translation>列表至少应有 {count} 项，而非 {found} 项</translation>
    </message>
    <message>
      <source>Local</source>
      <translation>局部位移</translation>
    </message>
    <message>
      <source>Local displacements of the print, rms per axis</source>
      <translation>印刷图案的局部位移，每轴的均方根值</translation>
    </message>
    <message>
      <source>Longest duration of a move</source>
      <translation>单次移动的最长时间</translation>
    </message>
    <message>
      <source>Longest duration of one move of one axis</source>
      <translation>单轴一次运动的最长时间</translation>
    </message>
    <message>
      <source>Longest wait for a login</source>
      <translation>登录的最长等待</translation>
    </message>
    <message>
      <source>Longest wait for a reply</source>
      <translation>应答的最长等待</translation>
    </message>
    <message>
      <source>Longest wait for a reply of the projector</source>
      <translation>等待投影仪应答的最长时间</translation>
    </message>
    <message>
      <source>Longest wait for a reply; a stop waits no longer than this</source>
      <translation>等待应答的最长时间；停止操作的等待不会超过此时间</translation>
    </message>
    <message>
      <source>Longest wait for access</source>
      <translation>获得访问的最长等待</translation>
    </message>
    <message>
      <source>Longest wait for one answer</source>
      <translation>等待一次应答的最长时间</translation>
    </message>
    <message>
      <source>Longest wait for one reply</source>
      <translation>等待一次应答的最长时间</translation>
    </message>
    <message>
      <source>Longest wait for the projector to leave standby</source>
      <translation>等待投影仪退出待机的最长时间</translation>
    </message>
    <message>
      <source>Longest wait for the start</source>
      <translation>启动的最长等待</translation>
    </message>
    <message>
      <source>Longest wait for the window to appear</source>
      <translation>等待窗口出现的最长时间</translation>
    </message>
    <message>
      <source>Longest wait for the window to paint an image</source>
      <translation>等待窗口绘制一幅图像的最长时间</translation>
    </message>
    <message>
      <source>Longest wait for wake-up</source>
      <translation>唤醒的最长等待</translation>
    </message>
    <message>
      <source>Loss of light in the corners</source>
      <translation>图像四角的光强损失</translation>
    </message>
    <message>
      <source>Lost after</source>
      <translation>判为失联的时间</translation>
    </message>
    <message>
      <source>Lower corner</source>
      <translation>下角点</translation>
    </message>
    <message>
      <source>Manifest</source>
      <translation>清单文件</translation>
    </message>
    <message>
      <source>Manufacturer</source>
      <translation>制造商</translation>
    </message>
    <message>
      <source>Manufacturer of the screen; empty: any</source>
      <translation>屏幕的制造商；留空：任意</translation>
    </message>
    <message>
      <source>Material</source>
      <translation>材料</translation>
    </message>
    <message>
      <source>Max thickness</source>
      <translation>最大厚度</translation>
    </message>
    <message>
      <source>Max thickness place</source>
      <translation>最大厚度位置</translation>
    </message>
    <message>
      <source>Mean depth at which light is scattered back below the surface</source>
      <translation>光在表面以下被散射返回的平均深度</translation>
    </message>
    <message>
      <source>Measured by another camera</source>
      <translation>由另一相机测量</translation>
    </message>
    <message>
      <source>Measurement report</source>
      <translation>测量报告</translation>
    </message>
    <message>
      <source>Mechanical unit</source>
      <translation>机械单元</translation>
    </message>
    <message>
      <source>Mechanical unit of the arm</source>
      <translation>机械臂的机械单元</translation>
    </message>
    <message>
      <source>Minutes</source>
      <translation>分钟</translation>
    </message>
    <message>
      <source>Modbus ASCII</source>
      <translation>Modbus ASCII</translation>
    </message>
    <message>
      <source>Modbus RTU</source>
      <translation>Modbus RTU</translation>
    </message>
    <message>
      <source>Modbus TCP</source>
      <translation>Modbus TCP</translation>
    </message>
    <message>
      <source>Model of the screen; empty: any</source>
      <translation>屏幕的型号；留空：任意</translation>
    </message>
    <message>
      <source>Module</source>
      <translation>模块</translation>
    </message>
    <message>
      <source>Motions</source>
      <translation>运动</translation>
    </message>
    <message>
      <source>Must be at least {ge}</source>
      <translation>不得小于 {ge}</translation>
    </message>
    <message>
      <source>Must be at most {le}</source>
      <translation>不得大于 {le}</translation>
    </message>
    <message>
      <source>Must be greater than {gt}</source>
      <translation>必须大于 {gt}</translation>
    </message>
    <message>
      <source>Must be less than {lt}</source>
      <translation>必须小于 {lt}</translation>
    </message>
    <message>
      <source>NO TOLERANCE</source>
      <translation>无公差</translation>
    </message>
    <message>
      <source>NOT MEASURED</source>
      <translation>未测量</translation>
    </message>
    <message>
      <source>NOT PROVEN</source>
      <translation>未证实</translation>
    </message>
    <message>
      <source>Name</source>
      <translation>名称</translation>
    </message>
    <message>
      <source>Name of the line, described in [links.NAME] of the rig description</source>
      <translation>线路名称，在测量系统描述的 [links.NAME] 中说明</translation>
    </message>
    <message>
      <source>Name of the network link; cameras with the same name share it</source>
      <translation>网络链路的名称；名称相同的相机共用该链路</translation>
    </message>
    <message>
      <source>Name of the reference camera</source>
      <translation>参考相机的名称</translation>
    </message>
    <message>
      <source>Name of the screen, such as DP-2; empty: any</source>
      <translation>屏幕的名称，例如 DP-2；留空：任意</translation>
    </message>
    <message>
      <source>Name of the shared rig; its table [links.NAME] has the settings of a virtual rig</source>
      <translation>共用测量系统的名称；其 [links.NAME] 表包含虚拟测量系统的设置</translation>
    </message>
    <message>
      <source>Name of this module</source>
      <translation>该模块的名称</translation>
    </message>
    <message>
      <source>Name or address of the robot's controller</source>
      <translation>机器人控制器的名称或地址</translation>
    </message>
    <message>
      <source>Name: alphabetically; number: by the numbers in the name, 2 before 10</source>
      <translation>名称：按字母顺序；编号：按名称中的数字，2 在 10 之前</translation>
    </message>
    <message>
      <source>No dimension has a tolerance: nothing is proven.</source>
      <translation>没有带公差的尺寸：什么也未证实。</translation>
    </message>
    <message>
      <source>No parity</source>
      <translation>无校验</translation>
    </message>
    <message>
      <source>No space left on device</source>
      <translation>磁盘空间不足</translation>
    </message>
    <message>
      <source>No such file or directory</source>
      <translation>没有该文件或文件夹</translation>
    </message>
    <message>
      <source>No: robot, guide and table are perfect</source>
      <translation>否：机器人、导轨和转台无误差</translation>
    </message>
    <message>
      <source>No: the mean image is quantised as it is</source>
      <translation>否：直接量化平均图像</translation>
    </message>
    <message>
      <source>None: as the command table says</source>
      <translation>未设置：按命令表</translation>
    </message>
    <message>
      <source>None: as the drive's map says</source>
      <translation>未设置：按驱动器映射</translation>
    </message>
    <message>
      <source>Not a directory</source>
      <translation>不是文件夹</translation>
    </message>
    <message>
      <source>Noto Sans</source>
      <translation>Noto Sans</translation>
    </message>
    <message>
      <source>Number</source>
      <translation>编号</translation>
    </message>
    <message>
      <source>Number of the axis, or address of the controller</source>
      <translation>轴的编号，或控制器的地址</translation>
    </message>
    <message>
      <source>Number of the certificate</source>
      <translation>证书编号</translation>
    </message>
    <message>
      <source>Numbers of the flash images: the first has patterns 0, 1, 2 in green, red, blue, the second 3, 4, 5 …</source>
      <translation>闪存图像的编号：第一幅的绿、红、蓝通道为图案 0、1、2，第二幅为 3、4、5……</translation>
    </message>
    <message>
      <source>Oblique to another camera</source>
      <translation>对另一相机过斜</translation>
    </message>
    <message>
      <source>Odd parity</source>
      <translation>奇校验</translation>
    </message>
    <message>
      <source>Of Robot Web Services: 1.0 for RobotWare 6, 2.0 for RobotWare 7</source>
      <translation>Robot Web Services 的版本：RobotWare 6 用 1.0，RobotWare 7 用 2.0</translation>
    </message>
    <message>
      <source>Of the camera that recorded the images</source>
      <translation>录制图像的相机的快门</translation>
    </message>
    <message>
      <source>Of the certificate</source>
      <translation>证书的编号</translation>
    </message>
    <message>
      <source>Of the flange's reorientation; none: a usual one, for arms without a kinematic model</source>
      <translation>法兰改变姿态的速度；未设置：常用值，用于没有运动学模型的机械臂</translation>
    </message>
    <message>
      <source>Of the flange; none: a usual one, for arms without a kinematic model</source>
      <translation>法兰的速度；未设置：常用值，用于没有运动学模型的机械臂</translation>
    </message>
    <message>
      <source>Of the largest joint speeds, at which a scan drives; none: a usual one</source>
      <translation>扫描时采用的速度占关节最大速度的比例；未设置：常用值</translation>
    </message>
    <message>
      <source>Of the room; the camera housings are warmer by self-heating</source>
      <translation>室温；相机外壳因自热而更高</translation>
    </message>
    <message>
      <source>Offset</source>
      <translation>偏移</translation>
    </message>
    <message>
      <source>Offset x</source>
      <translation>x 偏移</translation>
    </message>
    <message>
      <source>Offset y</source>
      <translation>y 偏移</translation>
    </message>
    <message>
      <source>One of impeller, gypsum, gear, sphere_plate, flat, or a mesh file (STL, PLY, OBJ)</source>
      <translation>impeller、gypsum、gear、sphere_plate、flat 之一，或网格文件（STL、PLY、OBJ）</translation>
    </message>
    <message>
      <source>Order conflict</source>
      <translation>级次冲突</translation>
    </message>
    <message>
      <source>Order of the images</source>
      <translation>图像顺序</translation>
    </message>
    <message>
      <source>Other exposures, for {area} mm²: {cause}.</source>
      <translation>换用其他曝光，用于 {area} mm²：{cause}。</translation>
    </message>
    <message>
      <source>Out of range</source>
      <translation>超出范围</translation>
    </message>
    <message>
      <source>Outlier</source>
      <translation>离群点</translation>
    </message>
    <message>
      <source>PASS</source>
      <translation>合格</translation>
    </message>
    <message>
      <source>Packed</source>
      <translation>打包格式</translation>
    </message>
    <message>
      <source>Packet delay</source>
      <translation>数据包间隔</translation>
    </message>
    <message>
      <source>Packet size</source>
      <translation>数据包大小</translation>
    </message>
    <message>
      <source>Packet size; above 1500 network card and switch need jumbo frames</source>
      <translation>数据包大小；超过 1500 时网卡和交换机须支持巨型帧</translation>
    </message>
    <message>
      <source>Paper, orthogonal</source>
      <translation>论文，正交</translation>
    </message>
    <message>
      <source>Paper: 32 and 33 px</source>
      <translation>论文：32 和 33 px</translation>
    </message>
    <message>
      <source>Parity</source>
      <translation>奇偶校验</translation>
    </message>
    <message>
      <source>Park pose</source>
      <translation>停放位姿</translation>
    </message>
    <message>
      <source>Part blur</source>
      <translation>工件模糊</translation>
    </message>
    <message>
      <source>Part excess</source>
      <translation>工件温升</translation>
    </message>
    <message>
      <source>Password</source>
      <translation>密码</translation>
    </message>
    <message>
      <source>Password of this user</source>
      <translation>该用户的密码</translation>
    </message>
    <message>
      <source>Pattern of the names: * for any characters, ? for one</source>
      <translation>文件名的模式：* 表示任意字符，? 表示一个字符</translation>
    </message>
    <message>
      <source>Penetration</source>
      <translation>穿透深度</translation>
    </message>
    <message>
      <source>Permission denied</source>
      <translation>没有权限</translation>
    </message>
    <message>
      <source>Photo response non-uniformity, relative standard deviation (EMVA 1288)</source>
      <translation>光响应非均匀性，相对标准差 (EMVA 1288)</translation>
    </message>
    <message>
      <source>Pitch</source>
      <translation>叶片间距角</translation>
    </message>
    <message>
      <source>Pitch, yaw and roll of the slide, half their range over the stroke</source>
      <translation>滑台的俯仰、偏摆和滚转，行程内范围的一半</translation>
    </message>
    <message>
      <source>Pitch, yaw and roll over the stroke, ±; none: usual ones</source>
      <translation>行程内的俯仰、偏摆和滚转，±；未设置：常用值</translation>
    </message>
    <message>
      <source>Pixel format</source>
      <translation>像素格式</translation>
    </message>
    <message>
      <source>Pixels</source>
      <translation>像素</translation>
    </message>
    <message>
      <source>Pixels per million with a high dark signal, up to full scale</source>
      <translation>暗信号偏高（直至满量程）的像素，每百万像素的个数</translation>
    </message>
    <message>
      <source>Plain level</source>
      <translation>均匀光灰度</translation>
    </message>
    <message>
      <source>Play of the flange along each axis between both directions of travel</source>
      <translation>法兰沿各轴两个运动方向之间的间隙</translation>
    </message>
    <message>
      <source>Play of the slide between both directions of travel</source>
      <translation>滑台两个运动方向之间的间隙</translation>
    </message>
    <message>
      <source>Play of the table between both directions of turning</source>
      <translation>转台两个旋转方向之间的间隙</translation>
    </message>
    <message>
      <source>Point measured</source>
      <translation>已测得点</translation>
    </message>
    <message>
      <source>Port</source>
      <translation>端口</translation>
    </message>
    <message>
      <source>Position (x, y, z)</source>
      <translation>位置 (x, y, z)</translation>
    </message>
    <message>
      <source>Position of the shoulder</source>
      <translation>肩部的位置</translation>
    </message>
    <message>
      <source>Position that the controller reports at angle 0 of the rig</source>
      <translation>测量系统角度为 0 时控制器报告的位置</translation>
    </message>
    <message>
      <source>Position tolerance</source>
      <translation>位置容差</translation>
    </message>
    <message>
      <source>Projector as a second screen</source>
      <translation>作为第二屏幕的投影仪</translation>
    </message>
    <message>
      <source>Projector in the head</source>
      <translation>测头中的投影仪</translation>
    </message>
    <message>
      <source>Pulses shorter than this are ignored; none: leave it as it is</source>
      <translation>短于此值的脉冲被忽略；未设置：保持不变</translation>
    </message>
    <message>
      <source>Quaternion</source>
      <translation>四元数</translation>
    </message>
    <message>
      <source>RAPID task that runs MeasureApp.mod</source>
      <translation>运行 MeasureApp.mod 的 RAPID 任务</translation>
    </message>
    <message>
      <source>Radial error motion</source>
      <translation>径向误差运动</translation>
    </message>
    <message>
      <source>Radial error motion of the table, half its range</source>
      <translation>转台的径向误差运动，范围的一半</translation>
    </message>
    <message>
      <source>Radial error motion, ± (ISO 230-7), without run-out; none: a usual one</source>
      <translation>径向误差运动，±（ISO 230-7），不含跳动；未设置：常用值</translation>
    </message>
    <message>
      <source>Range of rotation</source>
      <translation>旋转范围</translation>
    </message>
    <message>
      <source>Range of travel</source>
      <translation>行程范围</translation>
    </message>
    <message>
      <source>Read noise</source>
      <translation>读出噪声</translation>
    </message>
    <message>
      <source>Read-only file system</source>
      <translation>只读文件系统</translation>
    </message>
    <message>
      <source>Read-out of a row</source>
      <translation>一行的读出时间</translation>
    </message>
    <message>
      <source>Read-out of one row, for cameras that do not report their read-out</source>
      <translation>一行的读出时间，用于不报告读出时间的相机</translation>
    </message>
    <message>
      <source>Read-out time</source>
      <translation>读出时间</translation>
    </message>
    <message>
      <source>Read-out time, used where the camera does not report it</source>
      <translation>读出时间，在相机不报告时使用</translation>
    </message>
    <message>
      <source>Recommended. 12 images: 4 steps at 16, 17.84 and 18.14 px.</source>
      <translation>推荐。12 幅图像：16、17.84 和 18.14 px 处 4 步。</translation>
    </message>
    <message>
      <source>Red</source>
      <translation>红</translation>
    </message>
    <message>
      <source>Reference camera</source>
      <translation>参考相机</translation>
    </message>
    <message>
      <source>Reference exposure</source>
      <translation>参考曝光时间</translation>
    </message>
    <message>
      <source>Refuse</source>
      <translation>拒绝</translation>
    </message>
    <message>
      <source>Refuse triggers</source>
      <translation>拒绝触发</translation>
    </message>
    <message>
      <source>Refuse: no scan starts with an invalid calibration</source>
      <translation>拒绝：标定无效时不开始扫描</translation>
    </message>
    <message>
      <source>Regular expression with a group us or ms that finds the exposure in a name, such as _(?P&lt;us&gt;\d+)us</source>
      <translation>从文件名中提取曝光时间的正则表达式，含名为 us 或 ms 的组，例如 _(?P&lt;us&gt;\d+)us</translation>
    </message>
    <message>
      <source>Relative change of the focal length until the cameras are warm</source>
      <translation>相机达到热稳定之前焦距的相对变化</translation>
    </message>
    <message>
      <source>Reorientation of the flange</source>
      <translation>法兰改变姿态的速度</translation>
    </message>
    <message>
      <source>Report</source>
      <translation>报告</translation>
    </message>
    <message>
      <source>Response of the projector: light = level^gamma</source>
      <translation>投影仪的响应：光强 = 灰度级^gamma</translation>
    </message>
    <message>
      <source>Restart</source>
      <translation>从头开始</translation>
    </message>
    <message>
      <source>Rising edge of trigger output 1 after the start of the exposure</source>
      <translation>触发输出 1 的上升沿相对于曝光开始的延迟</translation>
    </message>
    <message>
      <source>Robot backlash</source>
      <translation>机器人反向间隙</translation>
    </message>
    <message>
      <source>Robot growth</source>
      <translation>机器人热伸长</translation>
    </message>
    <message>
      <source>Robot with the MeasureApp line protocol</source>
      <translation>采用 MeasureApp 行协议的机器人</translation>
    </message>
    <message>
      <source>Roboto</source>
      <translation>Roboto</translation>
    </message>
    <message>
      <source>Rolling share</source>
      <translation>卷帘快门占比</translation>
    </message>
    <message>
      <source>Rolling shutter</source>
      <translation>卷帘快门</translation>
    </message>
    <message>
      <source>Rolling, global-reset (for a projector with gated light) or global</source>
      <translation>卷帘快门、全局复位（用于光源可选通的投影仪）或全局快门</translation>
    </message>
    <message>
      <source>Rotary tables on a serial line: Newport, OWIS, Sigma-Koki</source>
      <translation>串行线上的转台：Newport、OWIS、Sigma-Koki</translation>
    </message>
    <message>
      <source>Rotation (x, y, z)</source>
      <translation>旋转 (x, y, z)</translation>
    </message>
    <message>
      <source>Rotation of the part</source>
      <translation>工件的旋转</translation>
    </message>
    <message>
      <source>Rotation of the part about x, then y, then z, before it is put on the table</source>
      <translation>工件放上转台之前依次绕 x、y、z 的旋转</translation>
    </message>
    <message>
      <source>SF Pro Text</source>
      <translation>SF Pro Text</translation>
    </message>
    <message>
      <source>Sample: {name}</source>
      <translation>示例：{name}</translation>
    </message>
    <message>
      <source>Saturated</source>
      <translation>饱和</translation>
    </message>
    <message>
      <source>Saving</source>
      <translation>保存</translation>
    </message>
    <message>
      <source>Scan with storing and clouds</source>
      <translation>扫描（含存储和点云）</translation>
    </message>
    <message>
      <source>Schema version</source>
      <translation>格式版本</translation>
    </message>
    <message>
      <source>Seconds per image</source>
      <translation>每幅图像的秒数</translation>
    </message>
    <message>
      <source>Seed of the hidden errors and all noise</source>
      <translation>隐含误差和所有噪声的随机种子</translation>
    </message>
    <message>
      <source>Segoe UI</source>
      <translation>Segoe UI</translation>
    </message>
    <message>
      <source>Segoe UI Variable</source>
      <translation>Segoe UI Variable</translation>
    </message>
    <message>
      <source>Sense of counting</source>
      <translation>计数方向</translation>
    </message>
    <message>
      <source>Sensor</source>
      <translation>传感器</translation>
    </message>
    <message>
      <source>Serial number</source>
      <translation>序列号</translation>
    </message>
    <message>
      <source>Serial number of the USB adapter</source>
      <translation>USB 适配器序列号</translation>
    </message>
    <message>
      <source>Serial number of the USB adapter: found again when its port has another name</source>
      <translation>USB 适配器的序列号：端口名称改变后仍可找到</translation>
    </message>
    <message>
      <source>Serial number of the projector's USB interface; empty: the only one connected</source>
      <translation>投影仪 USB 接口的序列号；留空：唯一连接的那台</translation>
    </message>
    <message>
      <source>Serial number of the screen; empty: any</source>
      <translation>屏幕的序列号；留空：任意</translation>
    </message>
    <message>
      <source>Serial port, such as /dev/ttyUSB0 or COM3; empty: found by usb_serial</source>
      <translation>串口，例如 /dev/ttyUSB0 或 COM3；留空：按 USB 适配器的序列号查找</translation>
    </message>
    <message>
      <source>Serial port, such as /dev/ttyUSB0 or COM3; empty: found by usb_serial, or TCP</source>
      <translation>串口，例如 /dev/ttyUSB0 或 COM3；留空：按 USB 适配器的序列号查找，或使用 TCP</translation>
    </message>
    <message>
      <source>Set-ups</source>
      <translation>装夹</translation>
    </message>
    <message>
      <source>Settings stored in the camera that are loaded first; empty: none</source>
      <translation>首先加载的、存储在相机中的设置集；留空：不加载</translation>
    </message>
    <message>
      <source>Settling time</source>
      <translation>稳定时间</translation>
    </message>
    <message>
      <source>Shadow</source>
      <translation>阴影</translation>
    </message>
    <message>
      <source>Shake</source>
      <translation>振动</translation>
    </message>
    <message>
      <source>Share of the exposure that falls on the next image, in the last row of a rolling shutter</source>
      <translation>卷帘快门最后一行中落入下一幅图像的曝光比例</translation>
    </message>
    <message>
      <source>Share of the joint speeds</source>
      <translation>关节速度的比例</translation>
    </message>
    <message>
      <source>Share of the light that is scattered over the image</source>
      <translation>散射到整幅图像的光的比例</translation>
    </message>
    <message>
      <source>Share of the way to the warm state when the world begins</source>
      <translation>仿真开始时已完成的升温比例</translation>
    </message>
    <message>
      <source>Shortest pulse on the trigger line; none: as in the default user set</source>
      <translation>触发线上的最短脉冲；未设置：按默认用户设置集</translation>
    </message>
    <message>
      <source>Shortest trigger pulse</source>
      <translation>最短触发脉冲</translation>
    </message>
    <message>
      <source>Shutter</source>
      <translation>快门</translation>
    </message>
    <message>
      <source>Size of a pixel</source>
      <translation>像元尺寸</translation>
    </message>
    <message>
      <source>Slot length</source>
      <translation>槽长</translation>
    </message>
    <message>
      <source>Slot width</source>
      <translation>槽宽</translation>
    </message>
    <message>
      <source>Smooth deviation of the surface from its nominal, rms along the normal</source>
      <translation>表面相对于名义模型的平滑偏差，沿法向的均方根值</translation>
    </message>
    <message>
      <source>Software</source>
      <translation>软件</translation>
    </message>
    <message>
      <source>Software: the program shows a pattern, then triggers; hardware: the projector triggers the cameras</source>
      <translation>软件：程序显示图案后触发；硬件：由投影仪触发相机</translation>
    </message>
    <message>
      <source>Source of hardware triggers</source>
      <translation>硬件触发的来源</translation>
    </message>
    <message>
      <source>Speed</source>
      <translation>速度</translation>
    </message>
    <message>
      <source>Speed in degrees per second; sent where the command table has a command for it</source>
      <translation>速度，单位为度每秒；命令表有相应命令时发送</translation>
    </message>
    <message>
      <source>Speed in mm or degrees per second</source>
      <translation>速度，单位为毫米或度每秒</translation>
    </message>
    <message>
      <source>Speed of rotation</source>
      <translation>旋转速度</translation>
    </message>
    <message>
      <source>Speed of the flange</source>
      <translation>法兰的速度</translation>
    </message>
    <message>
      <source>Speeds of the joints</source>
      <translation>关节速度</translation>
    </message>
    <message>
      <source>Sphere plate</source>
      <translation>球板</translation>
    </message>
    <message>
      <source>Sphere plate: diameters and centre distances</source>
      <translation>球板：直径与球心距</translation>
    </message>
    <message>
      <source>Stagger</source>
      <translation>安装角</translation>
    </message>
    <message>
      <source>Standard uncertainty of the scale, where the board states no class or certificate; 0: that of its class</source>
      <translation>标定板未给出等级或证书时尺度的标准不确定度；0：取其等级的值</translation>
    </message>
    <message>
      <source>Stands on the table</source>
      <translation>位于转台上</translation>
    </message>
    <message>
      <source>Station number; none: as the drive's map says</source>
      <translation>站号；未设置：按驱动器映射</translation>
    </message>
    <message>
      <source>Steel, zirconia, … or its expansion such as 11.5±0.6 ppm/K; empty: that of the part, so that both have the same expansion</source>
      <translation>钢、氧化锆等材料（steel、zirconia……），或其膨胀系数，例如 11.5±0.6 ppm/K；留空：与工件材料相同，两者膨胀一致</translation>
    </message>
    <message>
      <source>Stitching</source>
      <translation>拼接</translation>
    </message>
    <message>
      <source>Straightness error over the stroke, ±; none: a usual one</source>
      <translation>行程内的直线度误差，±；未设置：常用值</translation>
    </message>
    <message>
      <source>Strength of light reflected once between surfaces; 1: as the albedo has it</source>
      <translation>表面之间一次反射光的强度；1：由反照率决定</translation>
    </message>
    <message>
      <source>String should have at least {count} character</source>
      <translation>文本至少应有 {count} 个字符</translation>
    </message>
    <message>
      <source>String should have at least {count} characters</source>
      <translation>文本至少应有 {count} 个字符</translation>
    </message>
    <message>
      <source>String should have at most {count} characters</source>
      <translation>文本最多 {count} 个字符</translation>
    </message>
    <message>
      <source>String should match pattern {pattern}</source>
      <translation>文本应符合模式 {pattern}</translation>
    </message>
    <message>
      <source>Surface</source>
      <translation>表面</translation>
    </message>
    <message>
      <source>Surroundings</source>
      <translation>周围物体</translation>
    </message>
    <message>
      <source>Switch motors on</source>
      <translation>接通电机</translation>
    </message>
    <message>
      <source>Switch the motors on at the first move; otherwise a person does</source>
      <translation>首次运动时接通电机；否则由人员接通</translation>
    </message>
    <message>
      <source>Synchronisation</source>
      <translation>同步</translation>
    </message>
    <message>
      <source>System ID</source>
      <translation>系统 ID</translation>
    </message>
    <message>
      <source>Systematic</source>
      <translation>系统</translation>
    </message>
    <message>
      <source>TCP port</source>
      <translation>TCP 端口</translation>
    </message>
    <message>
      <source>TI LightCrafter 4500 (DLPC350)</source>
      <translation>TI LightCrafter 4500 投影仪 (DLPC350)</translation>
    </message>
    <message>
      <source>TOML file in the folder that lists images and exposures, in place of the three above</source>
      <translation>文件夹中列出图像和曝光时间的 TOML 文件，代替以上三项</translation>
    </message>
    <message>
      <source>Table axial</source>
      <translation>转台轴向误差</translation>
    </message>
    <message>
      <source>Table backlash</source>
      <translation>转台反向间隙</translation>
    </message>
    <message>
      <source>Table radial</source>
      <translation>转台径向误差</translation>
    </message>
    <message>
      <source>Table shift</source>
      <translation>转台平移</translation>
    </message>
    <message>
      <source>Table tilt</source>
      <translation>转台倾斜</translation>
    </message>
    <message>
      <source>Take over</source>
      <translation>接管</translation>
    </message>
    <message>
      <source>Take the robot from a program on another computer that has ended without releasing it</source>
      <translation>接管另一台计算机上已结束但未释放机器人的程序所占用的机器人</translation>
    </message>
    <message>
      <source>Task</source>
      <translation>任务</translation>
    </message>
    <message>
      <source>Temperature</source>
      <translation>温度</translation>
    </message>
    <message>
      <source>The dimension passes.</source>
      <translation>该尺寸合格。</translation>
    </message>
    <message>
      <source>The exposure bracket, long to short</source>
      <translation>包围曝光，由长到短</translation>
    </message>
    <message>
      <source>The linear guide under the robot, in the guide frame; none: no body</source>
      <translation>机器人下方的直线导轨，在导轨坐标系中；未设置：无实体</translation>
    </message>
    <message>
      <source>The pattern sets in its flash (source flash)</source>
      <translation>其闪存中的图案集（图案来源为闪存时）</translation>
    </message>
    <message>
      <source>The program evaluated no dimension: there is no verdict.</source>
      <translation>程序未评定任何尺寸：不作判定。</translation>
    </message>
    <message>
      <source>The table's top and three clamps are in the picture</source>
      <translation>图像中可见转台台面和三个夹爪</translation>
    </message>
    <message>
      <source>There is no such setting</source>
      <translation>没有此设置</translation>
    </message>
    <message>
      <source>Thermal drift</source>
      <translation>热漂移</translation>
    </message>
    <message>
      <source>Thermal expansion of the head</source>
      <translation>测头的热膨胀</translation>
    </message>
    <message>
      <source>Thermal expansion of the head's frame; default: aluminium</source>
      <translation>测头框架的热膨胀系数；默认：铝</translation>
    </message>
    <message>
      <source>Thickness</source>
      <translation>厚度</translation>
    </message>
    <message>
      <source>This text does not have the required form</source>
      <translation>此文本的格式不符合要求</translation>
    </message>
    <message>
      <source>Three close pitches</source>
      <translation>三个相近间距</translation>
    </message>
    <message>
      <source>Three close, 3 steps</source>
      <translation>三相近，3 步</translation>
    </message>
    <message>
      <source>Three close, 8 steps</source>
      <translation>三相近，8 步</translation>
    </message>
    <message>
      <source>Three close, orthogonal</source>
      <translation>三相近，正交</translation>
    </message>
    <message>
      <source>Three wide pitches</source>
      <translation>三个宽间距</translation>
    </message>
    <message>
      <source>Three wide, 8 steps</source>
      <translation>三宽，8 步</translation>
    </message>
    <message>
      <source>Three wide, from 32 px</source>
      <translation>三宽，从 32 px 起</translation>
    </message>
    <message>
      <source>Tilt error motion</source>
      <translation>倾斜误差运动</translation>
    </message>
    <message>
      <source>Tilt error motion (wobble), ±; none: a usual one</source>
      <translation>倾斜误差运动（摆动），±；未设置：常用值</translation>
    </message>
    <message>
      <source>Tilt error motion of the table, half its range</source>
      <translation>转台的倾斜误差运动，范围的一半</translation>
    </message>
    <message>
      <source>Time between two read-backs that must agree</source>
      <translation>必须一致的两次读回之间的时间</translation>
    </message>
    <message>
      <source>Time between two reads while the axis moves</source>
      <translation>轴运动时两次读取之间的时间</translation>
    </message>
    <message>
      <source>Time between two reads while the table turns</source>
      <translation>转台旋转时两次读取之间的时间</translation>
    </message>
    <message>
      <source>Time constant of this creep</source>
      <translation>该蠕动的时间常数</translation>
    </message>
    <message>
      <source>Time constant of warming up</source>
      <translation>升温的时间常数</translation>
    </message>
    <message>
      <source>Time scale</source>
      <translation>时间比例</translation>
    </message>
    <message>
      <source>Time to accelerate</source>
      <translation>加速时间</translation>
    </message>
    <message>
      <source>Timing</source>
      <translation>时序</translation>
    </message>
    <message>
      <source>To accelerate and brake; none: a usual one</source>
      <translation>加速和制动的时间；未设置：常用值</translation>
    </message>
    <message>
      <source>Tolerance at rest, angle</source>
      <translation>静止判定容差，角度</translation>
    </message>
    <message>
      <source>Tolerance at rest, position</source>
      <translation>静止判定容差，位置</translation>
    </message>
    <message>
      <source>Tolerance at the goal, angle</source>
      <translation>到位判定容差，角度</translation>
    </message>
    <message>
      <source>Tolerance at the goal, position</source>
      <translation>到位判定容差，位置</translation>
    </message>
    <message>
      <source>Tolerance of the position</source>
      <translation>到位容差</translation>
    </message>
    <message>
      <source>Total</source>
      <translation>总计</translation>
    </message>
    <message>
      <source>Trailing radius</source>
      <translation>尾缘半径</translation>
    </message>
    <message>
      <source>Transfer 10 and 12 bit in packed formats, where the camera has them</source>
      <translation>相机支持时以打包格式传输 10 位和 12 位图像</translation>
    </message>
    <message>
      <source>Trigger delay</source>
      <translation>触发延迟</translation>
    </message>
    <message>
      <source>Trigger inverted</source>
      <translation>触发信号反相</translation>
    </message>
    <message>
      <source>Trigger line</source>
      <translation>触发线</translation>
    </message>
    <message>
      <source>Trigger output 1 is low during the exposure</source>
      <translation>触发输出 1 在曝光期间为低电平</translation>
    </message>
    <message>
      <source>Triggered by</source>
      <translation>触发方式</translation>
    </message>
    <message>
      <source>Tuple should have at least {count} items after validation, not {found}</source>
      <translation>数组至少应有 {count} 项，而非 {found} 项</translation>
    </message>
    <message>
      <source>Tuple should have at most {count} items after validation, not {found}</source>
      <translation>数组最多 {count} 项，而非 {found} 项</translation>
    </message>
    <message>
      <source>Twist</source>
      <translation>扭转角</translation>
    </message>
    <message>
      <source>Two reads this far apart must agree</source>
      <translation>相隔此时间的两次读取必须一致</translation>
    </message>
    <message>
      <source>UDP port of a pose stream (option 689-1); none: no stream</source>
      <translation>位姿数据流的 UDP 端口（选项 689-1）；未设置：无数据流</translation>
    </message>
    <message>
      <source>Uncertain</source>
      <translation>不确定</translation>
    </message>
    <message>
      <source>Uncertainty (k = 2)</source>
      <translation>不确定度 (k = 2)</translation>
    </message>
    <message>
      <source>Uncertainty of the scale</source>
      <translation>比例的不确定度</translation>
    </message>
    <message>
      <source>Unexplained</source>
      <translation>未解释</translation>
    </message>
    <message>
      <source>Unit</source>
      <translation>单位</translation>
    </message>
    <message>
      <source>Unit ID</source>
      <translation>站号</translation>
    </message>
    <message>
      <source>Unit of a mesh file</source>
      <translation>网格文件的单位</translation>
    </message>
    <message>
      <source>Unmatched</source>
      <translation>未匹配</translation>
    </message>
    <message>
      <source>Upper corner</source>
      <translation>上角点</translation>
    </message>
    <message>
      <source>Used where the camera does not report it</source>
      <translation>在相机不报告时使用</translation>
    </message>
    <message>
      <source>User</source>
      <translation>用户</translation>
    </message>
    <message>
      <source>User of the controller</source>
      <translation>控制器的用户</translation>
    </message>
    <message>
      <source>User set</source>
      <translation>用户设置集</translation>
    </message>
    <message>
      <source>Valid for</source>
      <translation>有效期</translation>
    </message>
    <message>
      <source>Validity after the date of the calibration; none: no expiry</source>
      <translation>自标定日期起的有效期；未设置：不过期</translation>
    </message>
    <message>
      <source>Value error, </source>
      <translation>数值错误，</translation>
    </message>
    <message>
      <source>Vibration: displacement of each image across the fringes, standard deviation at full resolution</source>
      <translation>振动：每幅图像垂直于条纹方向的位移，全分辨率下的标准差</translation>
    </message>
    <message>
      <source>Video</source>
      <translation>视频</translation>
    </message>
    <message>
      <source>Video port</source>
      <translation>视频端口</translation>
    </message>
    <message>
      <source>Vignetting</source>
      <translation>渐晕</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translation>虚拟测量系统</translation>
    </message>
    <message>
      <source>Wait after the last axis has settled, before images are taken</source>
      <translation>最后一个轴稳定之后、拍摄图像之前的等待时间</translation>
    </message>
    <message>
      <source>Wait at the goal, in the controller</source>
      <translation>在目标处的等待时间，由控制器执行</translation>
    </message>
    <message>
      <source>Wait between two reads of a state that is to change</source>
      <translation>两次读取待变状态之间的等待时间</translation>
    </message>
    <message>
      <source>Wait for a free session of the controller</source>
      <translation>等待控制器空闲会话的时间</translation>
    </message>
    <message>
      <source>Warm share</source>
      <translation>升温比例</translation>
    </message>
    <message>
      <source>Warmth</source>
      <translation>热效应</translation>
    </message>
    <message>
      <source>Warn</source>
      <translation>警告</translation>
    </message>
    <message>
      <source>Weak modulation</source>
      <translation>调制度低</translation>
    </message>
    <message>
      <source>Weighted least squares</source>
      <translation>加权最小二乘</translation>
    </message>
    <message>
      <source>What drivers share: a serial line, a login, a world</source>
      <translation>驱动共用的资源：串行线路、登录或虚拟环境</translation>
    </message>
    <message>
      <source>When a limit is exceeded</source>
      <translation>超出限值时</translation>
    </message>
    <message>
      <source>Where patterns come from: programmed into its flash, or shown on the screen at its video port</source>
      <translation>图案的来源：写入其闪存，或显示在其视频端口的屏幕上</translation>
    </message>
    <message>
      <source>Where the images are</source>
      <translation>图像所在的位置</translation>
    </message>
    <message>
      <source>White</source>
      <translation>白</translation>
    </message>
    <message>
      <source>White level of the projector</source>
      <translation>投影仪的白电平</translation>
    </message>
    <message>
      <source>World</source>
      <translation>虚拟环境</translation>
    </message>
    <message>
      <source>Zhang, then bundle adjustment of all cameras</source>
      <translation>Zhang 法，然后对所有相机作光束法平差</translation>
    </message>
    <message>
      <source>Zhang, then bundle adjustment of all cameras and of the board's marks</source>
      <translation>Zhang 法，然后对所有相机和标定板标志点作光束法平差</translation>
    </message>
    <message>
      <source>at a rim</source>
      <translation>边缘处</translation>
    </message>
    <message>
      <source>bad</source>
      <translation>较差</translation>
    </message>
    <message>
      <source>board</source>
      <translation>标定板</translation>
    </message>
    <message>
      <source>brightness</source>
      <translation>亮度</translation>
    </message>
    <message>
      <source>built-in</source>
      <translation>内置</translation>
    </message>
    <message>
      <source>bytes</source>
      <translation>字节</translation>
    </message>
    <message>
      <source>centimetres</source>
      <translation>厘米</translation>
    </message>
    <message>
      <source>days</source>
      <translation>天</translation>
    </message>
    <message>
      <source>dimension</source>
      <translation>个尺寸</translation>
    </message>
    <message>
      <source>dimension {name}</source>
      <translation>尺寸 {name}</translation>
    </message>
    <message>
      <source>dimensions</source>
      <translation>个尺寸</translation>
    </message>
    <message>
      <source>file is not a database</source>
      <translation>文件不是数据库</translation>
    </message>
    <message>
      <source>five</source>
      <translation>5</translation>
    </message>
    <message>
      <source>four</source>
      <translation>4</translation>
    </message>
    <message>
      <source>full</source>
      <translation>全</translation>
    </message>
    <message>
      <source>gear</source>
      <translation>齿轮</translation>
    </message>
    <message>
      <source>good</source>
      <translation>良好</translation>
    </message>
    <message>
      <source>grazing for a partner</source>
      <translation>另一相机掠射</translation>
    </message>
    <message>
      <source>guide</source>
      <translation>导轨</translation>
    </message>
    <message>
      <source>gypsum</source>
      <translation>石膏</translation>
    </message>
    <message>
      <source>half</source>
      <translation>二分之一</translation>
    </message>
    <message>
      <source>horizontal</source>
      <translation>水平</translation>
    </message>
    <message>
      <source>impeller</source>
      <translation>叶轮</translation>
    </message>
    <message>
      <source>inch</source>
      <translation>英寸</translation>
    </message>
    <message>
      <source>inches</source>
      <translation>英寸</translation>
    </message>
    <message>
      <source>is a blade_section</source>
      <translation>是 blade_section</translation>
    </message>
    <message>
      <source>is not a blade_section</source>
      <translation>不是 blade_section</translation>
    </message>
    <message>
      <source>just now</source>
      <translation>刚刚</translation>
    </message>
    <message>
      <source>location</source>
      <translation>位置</translation>
    </message>
    <message>
      <source>metres</source>
      <translation>米</translation>
    </message>
    <message>
      <source>micrometres</source>
      <translation>微米</translation>
    </message>
    <message>
      <source>millimetres</source>
      <translation>毫米</translation>
    </message>
    <message>
      <source>no tolerance</source>
      <translation>无公差</translation>
    </message>
    <message>
      <source>no viewpoint sees it</source>
      <translation>没有视点能看到</translation>
    </message>
    <message>
      <source>one</source>
      <translation>1</translation>
    </message>
    <message>
      <source>one feature</source>
      <translation>一个特征</translation>
    </message>
    <message>
      <source>or nothing for no verdict</source>
      <translation>或留空以不作判定</translation>
    </message>
    <message>
      <source>orientation</source>
      <translation>方向</translation>
    </message>
    <message>
      <source>part</source>
      <translation>工件</translation>
    </message>
    <message>
      <source>partner grazing</source>
      <translation>对方掠射</translation>
    </message>
    <message>
      <source>position</source>
      <translation>位置</translation>
    </message>
    <message>
      <source>positions</source>
      <translation>位置</translation>
    </message>
    <message>
      <source>quarter</source>
      <translation>四分之一</translation>
    </message>
    <message>
      <source>robot</source>
      <translation>机器人</translation>
    </message>
    <message>
      <source>saturated</source>
      <translation>饱和</translation>
    </message>
    <message>
      <source>seen by another</source>
      <translation>由另一相机看到</translation>
    </message>
    <message>
      <source>six</source>
      <translation>6</translation>
    </message>
    <message>
      <source>sphere_plate</source>
      <translation>球板</translation>
    </message>
    <message>
      <source>standard deviation above the required one</source>
      <translation>标准差超出要求</translation>
    </message>
    <message>
      <source>table</source>
      <translation>转台</translation>
    </message>
    <message>
      <source>the alignment</source>
      <translation>对齐</translation>
    </message>
    <message>
      <source>the alignment {name}</source>
      <translation>对齐 {name}</translation>
    </message>
    <message>
      <source>the program</source>
      <translation>程序</translation>
    </message>
    <message>
      <source>three</source>
      <translation>3</translation>
    </message>
    <message>
      <source>time</source>
      <translation>时间</translation>
    </message>
    <message>
      <source>too dark</source>
      <translation>太暗</translation>
    </message>
    <message>
      <source>touches the support</source>
      <translation>与支承接触</translation>
    </message>
    <message>
      <source>two</source>
      <translation>2</translation>
    </message>
    <message>
      <source>two features</source>
      <translation>两个特征</translation>
    </message>
    <message>
      <source>usable</source>
      <translation>可用</translation>
    </message>
    <message>
      <source>usual</source>
      <translation>普通</translation>
    </message>
    <message>
      <source>vertical</source>
      <translation>竖直</translation>
    </message>
    <message>
      <source>visible, but its pixels have no point</source>
      <translation>可见，但其像素没有点</translation>
    </message>
    <message>
      <source>{bits} bit ({name})</source>
      <translation>{bits} 位 ({name})</translation>
    </message>
    <message>
      <source>{bits} bit, packed ({name})</source>
      <translation>{bits} 位，打包 ({name})</translation>
    </message>
    <message>
      <source>{days} days ago</source>
      <translation>{days} 天前</translation>
    </message>
    <message>
      <source>{hours} h ago</source>
      <translation>{hours} 小时前</translation>
    </message>
    <message>
      <source>{list}, of {count}.</source>
      <translation>{list}，共 {count}。</translation>
    </message>
    <message>
      <source>{minutes} min ago</source>
      <translation>{minutes} 分钟前</translation>
    </message>
    <message>
      <source>{n} fail</source>
      <translation>{n} 不合格</translation>
    </message>
    <message>
      <source>{n} not measured</source>
      <translation>{n} 未测量</translation>
    </message>
    <message>
      <source>{n} not proven</source>
      <translation>{n} 未证实</translation>
    </message>
    <message>
      <source>{n} pass</source>
      <translation>{n} 合格</translation>
    </message>
    <message>
      <source>{n} rejected</source>
      <translation>{n} 个被剔除</translation>
    </message>
    <message>
      <source>{n} without tolerance</source>
      <translation>{n} 无公差</translation>
    </message>
  </context>
  <context>
    <name>main_window</name>
    <message>
      <source>MeasureApp</source>
      <translation>MeasureApp</translation>
    </message>
    <message>
      <source>Save the log for support</source>
      <translation>保存日志以供支持</translation>
    </message>
    <message>
      <source>Saving the log</source>
      <translation>正在保存日志</translation>
    </message>
    <message>
      <source>Send this file to support.</source>
      <translation>请将此文件发送给支持人员。</translation>
    </message>
    <message>
      <source>The log is saved to {file}.</source>
      <translation>日志已保存到 {file}。</translation>
    </message>
    <message>
      <source>{name} – MeasureApp</source>
      <translation>{name} – MeasureApp</translation>
    </message>
  </context>
  <context>
    <name>operator</name>
    <message>
      <source>
The first run of this part counts.</source>
      <translation>
此工件以第一次测量为准。</translation>
    </message>
    <message>
      <source>A PIN is set. Type a new one twice to change it.</source>
      <translation>已设置 PIN。更改时请将新 PIN 输入两次。</translation>
    </message>
    <message>
      <source>A camera has moved since the calibration: the values may be wrong. Call the engineer.</source>
      <translation>标定后有相机移动：数值可能有误。请呼叫工程师。</translation>
    </message>
    <message>
      <source>A measurement is running. Stop it before you close the window.</source>
      <translation>测量正在进行。关闭窗口前请先停止。</translation>
    </message>
    <message>
      <source>About {seconds}</source>
      <translation>约 {seconds}</translation>
    </message>
    <message>
      <source>All viewpoints are stored. Hold Resume to compute the result, or start again.</source>
      <translation>所有视点已存储。按住“继续”计算结果，或重新开始。</translation>
    </message>
    <message>
      <source>Back</source>
      <translation>返回</translation>
    </message>
    <message>
      <source>Back to operator mode</source>
      <translation>返回操作模式</translation>
    </message>
    <message>
      <source>Call the engineer</source>
      <translation>呼叫工程师</translation>
    </message>
    <message>
      <source>Capital letters</source>
      <translation>大写字母</translation>
    </message>
    <message>
      <source>Changed since</source>
      <translation>此后有更改</translation>
    </message>
    <message>
      <source>Confirmed: part clamped, cell clear</source>
      <translation>已确认：工件已装夹，工作站畅通</translation>
    </message>
    <message>
      <source>Delete the last letter</source>
      <translation>删除最后一个字符</translation>
    </message>
    <message>
      <source>Details</source>
      <translation>详细信息</translation>
    </message>
    <message>
      <source>Done</source>
      <translation>完成</translation>
    </message>
    <message>
      <source>Engineer</source>
      <translation>工程师</translation>
    </message>
    <message>
      <source>Engineer called at {time:%H:%M}. {what}</source>
      <translation>{time:%H:%M} 已呼叫工程师。{what}</translation>
    </message>
    <message>
      <source>Engineer's role ends after</source>
      <translation>工程师角色结束于</translation>
    </message>
    <message>
      <source>Engineer…</source>
      <translation>工程师…</translation>
    </message>
    <message>
      <source>Enter</source>
      <translation>回车</translation>
    </message>
    <message>
      <source>Fill in the fields marked *.</source>
      <translation>请填写带 * 的项。</translation>
    </message>
    <message>
      <source>First-pass yield {first_pass_yield}</source>
      <translation>一次合格率 {first_pass_yield}</translation>
    </message>
    <message>
      <source>Folder of the measured parts</source>
      <translation>已测工件的文件夹</translation>
    </message>
    <message>
      <source>Folder of the part programs</source>
      <translation>工件程序的文件夹</translation>
    </message>
    <message>
      <source>For the engineer: {remedy}</source>
      <translation>供工程师参考：{remedy}</translation>
    </message>
    <message>
      <source>Go on</source>
      <translation>继续</translation>
    </message>
    <message>
      <source>Hide</source>
      <translation>隐藏</translation>
    </message>
    <message>
      <source>Hold for 1 s: part clamped, cell clear</source>
      <translation>按住 1 秒：工件已装夹，工作站畅通</translation>
    </message>
    <message>
      <source>Identify</source>
      <translation>识别</translation>
    </message>
    <message>
      <source>If it is forgotten: measureapp gui --reset-engineer-pin</source>
      <translation>若忘记：measureapp gui --reset-engineer-pin</translation>
    </message>
    <message>
      <source>If the part has not been moved, hold Resume: the measurement goes on with {following}. If it has been moved, start again.</source>
      <translation>若工件未被移动，按住“继续”：测量从 {following} 继续。若已移动，请重新开始。</translation>
    </message>
    <message>
      <source>Images are taken</source>
      <translation>正在拍摄图像</translation>
    </message>
    <message>
      <source>It could not be measured.</source>
      <translation>无法测量。</translation>
    </message>
    <message>
      <source>It was clamped wrongly</source>
      <translation>装夹有误</translation>
    </message>
    <message>
      <source>It was reworked</source>
      <translation>已返工</translation>
    </message>
    <message>
      <source>Keyboard</source>
      <translation>键盘</translation>
    </message>
    <message>
      <source>Last</source>
      <translation>上一个</translation>
    </message>
    <message>
      <source>Load</source>
      <translation>装载</translation>
    </message>
    <message>
      <source>Measure this part again?</source>
      <translation>重新测量此工件？</translation>
    </message>
    <message>
      <source>MeasureApp/parts in your home</source>
      <translation>主目录下的 MeasureApp/parts</translation>
    </message>
    <message>
      <source>MeasureApp/programs in your home</source>
      <translation>主目录下的 MeasureApp/programs</translation>
    </message>
    <message>
      <source>Measured parts</source>
      <translation>已测工件</translation>
    </message>
    <message>
      <source>Measured {when}: {verdict}. Measure it again as run {number}? All runs are kept; without a reason the first one counts.</source>
      <translation>{when}已测量：{verdict}。作为第 {number} 次重新测量？所有测量都会保留；无原因时以第一次为准。</translation>
    </message>
    <message>
      <source>Measured {when}: {verdict}; an earlier run counts: {counted}. Measure it again as run {number}? All runs are kept.</source>
      <translation>{when}已测量：{verdict}；以较早的测量为准：{counted}。作为第 {number} 次重新测量？所有测量都会保留。</translation>
    </message>
    <message>
      <source>New PIN or password</source>
      <translation>新 PIN 或密码</translation>
    </message>
    <message>
      <source>Next</source>
      <translation>下一步</translation>
    </message>
    <message>
      <source>Next part</source>
      <translation>下一个工件</translation>
    </message>
    <message>
      <source>No PIN is set: anyone can leave operator mode. Type one twice, 4 or more characters.</source>
      <translation>未设置 PIN：任何人都可离开操作模式。请输入两次，至少 4 个字符。</translation>
    </message>
    <message>
      <source>No part program has “{words}” in its name or numbers.</source>
      <translation>没有名称或编号包含“{words}”的工件程序。</translation>
    </message>
    <message>
      <source>No part programs in the folder. Save one with Save as a template in the menu Project.</source>
      <translation>文件夹中没有工件程序。请用“项目”菜单中的“保存为模板”保存一个。</translation>
    </message>
    <message>
      <source>No reason</source>
      <translation>无原因</translation>
    </message>
    <message>
      <source>No rig</source>
      <translation>无测量系统</translation>
    </message>
    <message>
      <source>No viewpoint was stored yet.</source>
      <translation>尚未存储任何视点。</translation>
    </message>
    <message>
      <source>Not everything could be measured. Clean the part, see that it lies right, and press Repeat.</source>
      <translation>有些尺寸未能测得。请清洁工件，检查其放置是否正确，然后按“重复”。</translation>
    </message>
    <message>
      <source>Not measured yet</source>
      <translation>尚未测量</translation>
    </message>
    <message>
      <source>Not released</source>
      <translation>未发布</translation>
    </message>
    <message>
      <source>Once more</source>
      <translation>再试一次</translation>
    </message>
    <message>
      <source>Operator mode</source>
      <translation>操作模式</translation>
    </message>
    <message>
      <source>Operators are offered released programs only. Whatever changes a program makes it a new one, which is released again.</source>
      <translation>只向操作员提供已发布的程序。程序一经更改即为新程序，须重新发布。</translation>
    </message>
    <message>
      <source>Order</source>
      <translation>订单</translation>
    </message>
    <message>
      <source>PIN forgotten? Run this command on this computer, then set a new one: measureapp gui --reset-engineer-pin</source>
      <translation>忘记 PIN？请在此计算机运行此命令，然后设置新 PIN：measureapp gui --reset-engineer-pin</translation>
    </message>
    <message>
      <source>PIN or password</source>
      <translation>PIN 或密码</translation>
    </message>
    <message>
      <source>PIN or password of the engineer</source>
      <translation>工程师的 PIN 或密码</translation>
    </message>
    <message>
      <source>Part program</source>
      <translation>工件程序</translation>
    </message>
    <message>
      <source>Part programs</source>
      <translation>工件程序</translation>
    </message>
    <message>
      <source>Pause</source>
      <translation>暂停</translation>
    </message>
    <message>
      <source>Paused</source>
      <translation>已暂停</translation>
    </message>
    <message>
      <source>Pausing…</source>
      <translation>正在暂停…</translation>
    </message>
    <message>
      <source>Progress of the measurement</source>
      <translation>测量进度</translation>
    </message>
    <message>
      <source>Put the part aside. If it was dirty or clamped wrongly, mend that and press Repeat.</source>
      <translation>请把工件放到一边。若工件不干净或装夹有误，请改正后按“重复”。</translation>
    </message>
    <message>
      <source>Put the part in</source>
      <translation>放入工件</translation>
    </message>
    <message>
      <source>Put the part on the table as the engineer has shown you, and clamp it.</source>
      <translation>按工程师的示范将工件放在转台上并装夹。</translation>
    </message>
    <message>
      <source>Reading the part programs…</source>
      <translation>正在读取工件程序…</translation>
    </message>
    <message>
      <source>Release</source>
      <translation>发布</translation>
    </message>
    <message>
      <source>Release the selected programs for operators, as their next revision</source>
      <translation>将所选程序作为下一版发布给操作员</translation>
    </message>
    <message>
      <source>Release {revision}</source>
      <translation>发布 {revision}</translation>
    </message>
    <message>
      <source>Released by</source>
      <translation>发布人</translation>
    </message>
    <message>
      <source>Released by {by}, {at}</source>
      <translation>由 {by} 于 {at} 发布</translation>
    </message>
    <message>
      <source>Released part programs</source>
      <translation>已发布的工件程序</translation>
    </message>
    <message>
      <source>Remarks</source>
      <translation>备注</translation>
    </message>
    <message>
      <source>Repeat</source>
      <translation>重复</translation>
    </message>
    <message>
      <source>Report filed: {name}</source>
      <translation>报告已归档：{name}</translation>
    </message>
    <message>
      <source>Resume: hold for 1 s</source>
      <translation>继续：按住 1 秒</translation>
    </message>
    <message>
      <source>Rig stopped</source>
      <translation>测量系统已停止</translation>
    </message>
    <message>
      <source>Save</source>
      <translation>保存</translation>
    </message>
    <message>
      <source>Scan the code, or type the name or number of the part</source>
      <translation>扫描代码，或输入工件名称或编号</translation>
    </message>
    <message>
      <source>Search for a part</source>
      <translation>搜索工件</translation>
    </message>
    <message>
      <source>Shifts begin at</source>
      <translation>班次开始于</translation>
    </message>
    <message>
      <source>Show the result</source>
      <translation>显示结果</translation>
    </message>
    <message>
      <source>Since {since:%H:%M}: {count}</source>
      <translation>自 {since:%H:%M}：{count}</translation>
    </message>
    <message>
      <source>Space</source>
      <translation>空格</translation>
    </message>
    <message>
      <source>Start</source>
      <translation>开始</translation>
    </message>
    <message>
      <source>Start again</source>
      <translation>重新开始</translation>
    </message>
    <message>
      <source>State</source>
      <translation>状态</translation>
    </message>
    <message>
      <source>State why this part is measured again.</source>
      <translation>请说明为何重新测量此工件。</translation>
    </message>
    <message>
      <source>Stop</source>
      <translation>停止</translation>
    </message>
    <message>
      <source>Stop is not an emergency stop.</source>
      <translation>“停止”不是急停。</translation>
    </message>
    <message>
      <source>Stopping…</source>
      <translation>正在停止…</translation>
    </message>
    <message>
      <source>The folder of this part is gone, with all that was stored in it.</source>
      <translation>此工件的文件夹已不存在，其中存储的内容也随之丢失。</translation>
    </message>
    <message>
      <source>The images are checked</source>
      <translation>正在检查图像</translation>
    </message>
    <message>
      <source>The images are stored</source>
      <translation>正在保存图像</translation>
    </message>
    <message>
      <source>The measured points appear here when the first viewpoint is computed.</source>
      <translation>计算出第一个视点后，测量点显示在此处。</translation>
    </message>
    <message>
      <source>The measurement has ended early</source>
      <translation>测量提前结束</translation>
    </message>
    <message>
      <source>The measurement is being prepared</source>
      <translation>正在准备测量</translation>
    </message>
    <message>
      <source>The pages are being drawn…</source>
      <translation>正在绘制页面…</translation>
    </message>
    <message>
      <source>The part was cleaned</source>
      <translation>工件已清洁</translation>
    </message>
    <message>
      <source>The program has no tolerances, so nothing was decided. Call the engineer.</source>
      <translation>程序没有给出公差，因此无法判定。请呼叫工程师。</translation>
    </message>
    <message>
      <source>The program states no tolerance.</source>
      <translation>程序没有规定公差。</translation>
    </message>
    <message>
      <source>The program's Stop is not an emergency stop: in danger press the emergency stop of the machine.</source>
      <translation>程序的“停止”不是急停：危险时请按机器的急停按钮。</translation>
    </message>
    <message>
      <source>The report cannot be shown. It is filed with the part.</source>
      <translation>无法显示报告。它已随工件归档。</translation>
    </message>
    <message>
      <source>The result is being filed…</source>
      <translation>正在归档结果…</translation>
    </message>
    <message>
      <source>The rig is calibrated first</source>
      <translation>首先标定测量系统</translation>
    </message>
    <message>
      <source>The rig moves</source>
      <translation>测量系统正在移动</translation>
    </message>
    <message>
      <source>The rig settles</source>
      <translation>测量系统正在稳定</translation>
    </message>
    <message>
      <source>The two PINs differ.</source>
      <translation>两次 PIN 不一致。</translation>
    </message>
    <message>
      <source>The verdict is {verdict}.</source>
      <translation>判定结果：{verdict}。</translation>
    </message>
    <message>
      <source>There is no part program in {folder}. Call the engineer.</source>
      <translation>{folder} 中没有工件程序。请呼叫工程师。</translation>
    </message>
    <message>
      <source>This file cannot be used.</source>
      <translation>无法使用此文件。</translation>
    </message>
    <message>
      <source>Too close to a limit to decide. Clean the part and press Repeat, or put it aside and call the engineer.</source>
      <translation>离极限太近，无法判定。请清洁工件后按“重复”，或把它放到一边并呼叫工程师。</translation>
    </message>
    <message>
      <source>When it is back, hold Resume. Otherwise start again.</source>
      <translation>文件夹恢复后，请按住“继续”；否则请重新开始。</translation>
    </message>
    <message>
      <source>Which part?</source>
      <translation>哪个工件？</translation>
    </message>
    <message>
      <source>Why is it measured again?</source>
      <translation>为何重新测量？</translation>
    </message>
    <message>
      <source>With a reason the new run counts; without one the first run counts. All runs are kept.</source>
      <translation>说明原因则以新测量为准；否则以第一次为准。所有测量都会保留。</translation>
    </message>
    <message>
      <source>Your name</source>
      <translation>您的姓名</translation>
    </message>
    <message>
      <source>Your name, printed in every report</source>
      <translation>您的姓名，打印在每份报告中</translation>
    </message>
    <message>
      <source>ZXCVBNM,:</source>
      <translation>ZXCVBNM,:</translation>
    </message>
    <message>
      <source>at least {limit}</source>
      <translation>至少 {limit}</translation>
    </message>
    <message>
      <source>at least {limit}, measured to {u}</source>
      <translation>至少 {limit}，测量不确定度 {u}</translation>
    </message>
    <message>
      <source>at least {limit}: {past} too small</source>
      <translation>至少 {limit}：小 {past}</translation>
    </message>
    <message>
      <source>at most {limit}</source>
      <translation>最多 {limit}</translation>
    </message>
    <message>
      <source>at most {limit}, measured to {u}</source>
      <translation>最多 {limit}，测量不确定度 {u}</translation>
    </message>
    <message>
      <source>at most {limit}: {past} too large</source>
      <translation>最多 {limit}：大 {past}</translation>
    </message>
    <message>
      <source>clamped again</source>
      <translation>重新装夹</translation>
    </message>
    <message>
      <source>part program</source>
      <translation>个工件程序</translation>
    </message>
    <message>
      <source>part programs</source>
      <translation>个工件程序</translation>
    </message>
    <message>
      <source>today {time}</source>
      <translation>今天 {time}</translation>
    </message>
    <message>
      <source>{count} not released by the engineer: not offered here.</source>
      <translation>{count}未经工程师发布：此处不提供。</translation>
    </message>
    <message>
      <source>{count} part</source>
      <translation>{count} 个工件</translation>
    </message>
    <message>
      <source>{count} parts</source>
      <translation>{count} 个工件</translation>
    </message>
    <message>
      <source>{drawing} rev. {revision}</source>
      <translation>{drawing} 版本 {revision}</translation>
    </message>
    <message>
      <source>{elapsed} so far</source>
      <translation>已用 {elapsed}</translation>
    </message>
    <message>
      <source>{elapsed}, about {left} left</source>
      <translation>{elapsed}，约剩 {left}</translation>
    </message>
    <message>
      <source>{serial}, measured {when}: {verdict}</source>
      <translation>{serial}，{when}测量：{verdict}</translation>
    </message>
    <message>
      <source>{step}: viewpoint {number} of {all}</source>
      <translation>{step}：视点 {number}/{all}</translation>
    </message>
    <message>
      <source>{stored} of {planned} viewpoints are stored and kept.</source>
      <translation>已存储并保留 {planned} 个视点中的 {stored} 个。</translation>
    </message>
  </context>
  <context>
    <name>pages</name>
    <message>
      <source>, {direction} fringes</source>
      <translation>，{direction}条纹</translation>
    </message>
    <message>
      <source>1 of {counted} pixels</source>
      <translation>1/{counted} 像素</translation>
    </message>
    <message>
      <source>&lt; 1 of {counted} pixels</source>
      <translation>&lt; 1/{counted} 像素</translation>
    </message>
    <message>
      <source>A part that was measured on the virtual rig</source>
      <translation>在虚拟测量系统上测得的工件</translation>
    </message>
    <message>
      <source>Acquisition time</source>
      <translation>采集时间</translation>
    </message>
    <message>
      <source>Age of the calibration, and what it adds to a length between two views, before registration (k = 2).</source>
      <translation>标定的时间，以及配准前它给两视图间长度增加的不确定度 (k = 2)。</translation>
    </message>
    <message>
      <source>All parts fit well: scan next.</source>
      <translation>各部分均良好：请扫描。</translation>
    </message>
    <message>
      <source>All viewpoints</source>
      <translation>所有视点</translation>
    </message>
    <message>
      <source>Another template…</source>
      <translation>其他模板…</translation>
    </message>
    <message>
      <source>As the window</source>
      <translation>与窗口相同</translation>
    </message>
    <message>
      <source>Assumed modulation</source>
      <translation>假定调制度</translation>
    </message>
    <message>
      <source>At least {seconds}</source>
      <translation>至少 {seconds}</translation>
    </message>
    <message>
      <source>Blur of its images</source>
      <translation>其图像的模糊</translation>
    </message>
    <message>
      <source>Board moved by {explained_mm} rms</source>
      <translation>标定板移动了 {explained_mm}（均方根）</translation>
    </message>
    <message>
      <source>Brightness</source>
      <translation>亮度</translation>
    </message>
    <message>
      <source>Calibrate</source>
      <translation>标定</translation>
    </message>
    <message>
      <source>Calibrate automatically…</source>
      <translation>自动标定…</translation>
    </message>
    <message>
      <source>Calibrate the rig on the Calibrate page</source>
      <translation>请在“标定”页标定测量系统</translation>
    </message>
    <message>
      <source>Calibrate the whole rig again, or one part</source>
      <translation>重新标定整个测量系统或其一部分</translation>
    </message>
    <message>
      <source>Calibrate the whole rig…</source>
      <translation>标定整个测量系统…</translation>
    </message>
    <message>
      <source>Calibrated {age} · adds {added} (k = 2) {words}</source>
      <translation>{age}标定 · 增加 {added} (k = 2) {words}</translation>
    </message>
    <message>
      <source>Calibrated {age} · check it !</source>
      <translation>{age}标定 · 请检查 !</translation>
    </message>
    <message>
      <source>Calibrated {age} · poor fit ✗</source>
      <translation>{age}标定 · 拟合差 ✗</translation>
    </message>
    <message>
      <source>Calibrated {age}. {judgement}</source>
      <translation>{age}标定。{judgement}</translation>
    </message>
    <message>
      <source>Calibrating…</source>
      <translation>正在标定…</translation>
    </message>
    <message>
      <source>Camera </source>
      <translation>相机</translation>
    </message>
    <message>
      <source>Camera at {vector} mm on the flange</source>
      <translation>相机位于法兰上 {vector} mm</translation>
    </message>
    <message>
      <source>Camera pairs</source>
      <translation>相机对</translation>
    </message>
    <message>
      <source>Camera {who} moved · {error_mm} {mark}</source>
      <translation>相机 {who} 已移动 · {error_mm} {mark}</translation>
    </message>
    <message>
      <source>Cameras only…</source>
      <translation>仅相机…</translation>
    </message>
    <message>
      <source>Cannot be used</source>
      <translation>无法使用</translation>
    </message>
    <message>
      <source>Check the path, the free space and the permissions.</source>
      <translation>请检查路径、可用空间和权限。</translation>
    </message>
    <message>
      <source>Choose the folder of a report template</source>
      <translation>选择报告模板的文件夹</translation>
    </message>
    <message>
      <source>Click the first point</source>
      <translation>单击第一点</translation>
    </message>
    <message>
      <source>Click the second point</source>
      <translation>单击第二点</translation>
    </message>
    <message>
      <source>Clip box</source>
      <translation>裁剪盒</translation>
    </message>
    <message>
      <source>Company</source>
      <translation>公司</translation>
    </message>
    <message>
      <source>Contribution to the kinematic position of a point (k = 2)</source>
      <translation>对点的运动学位置的贡献 (k = 2)</translation>
    </message>
    <message>
      <source>Contribution, k = 2</source>
      <translation>贡献，k = 2</translation>
    </message>
    <message>
      <source>Deviation from the nominal</source>
      <translation>与名义模型的偏差</translation>
    </message>
    <message>
      <source>Direction {vector}, scale {scale:.6f}</source>
      <translation>方向 {vector}，比例 {scale:.6f}</translation>
    </message>
    <message>
      <source>Disk space</source>
      <translation>磁盘空间</translation>
    </message>
    <message>
      <source>Distance</source>
      <translation>距离</translation>
    </message>
    <message>
      <source>Distance from the merged surface, and σ</source>
      <translation>到合并表面的距离，以及 σ</translation>
    </message>
    <message>
      <source>Distance of two single points. A dimension of the inspection program uses thousands of points and has a smaller uncertainty.</source>
      <translation>两个单点的距离。检测程序的尺寸使用数千个点，不确定度更小。</translation>
    </message>
    <message>
      <source>Error motions, guide</source>
      <translation>误差运动，导轨</translation>
    </message>
    <message>
      <source>Error motions, table</source>
      <translation>误差运动，转台</translation>
    </message>
    <message>
      <source>Estimate</source>
      <translation>估计值</translation>
    </message>
    <message>
      <source>Everything</source>
      <translation>全部</translation>
    </message>
    <message>
      <source>Export</source>
      <translation>导出</translation>
    </message>
    <message>
      <source>First point</source>
      <translation>第一点</translation>
    </message>
    <message>
      <source>Fix the calibration board on the table, then calibrate the whole rig in one automatic run. The cameras alone can be calibrated from recorded images too.</source>
      <translation>将标定板固定在转台上，然后一次自动运行标定整个测量系统。仅相机也可由录制的图像标定。</translation>
    </message>
    <message>
      <source>Focal length {matrix:.1f} px, centre ({matrix_2:.1f}, {matrix_3:.1f}) px</source>
      <translation>焦距 {matrix:.1f} px，中心 ({matrix_2:.1f}, {matrix_3:.1f}) px</translation>
    </message>
    <message>
      <source>Focal length, distortion and pose of every camera</source>
      <translation>每台相机的焦距、畸变和位姿</translation>
    </message>
    <message>
      <source>Good</source>
      <translation>良好</translation>
    </message>
    <message>
      <source>Guard band</source>
      <translation>保护带</translation>
    </message>
    <message>
      <source>Guide</source>
      <translation>导轨</translation>
    </message>
    <message>
      <source>Guide direction over {stroke:.0f} mm</source>
      <translation>{stroke:.0f} mm 上的导轨方向</translation>
    </message>
    <message>
      <source>Guide scale over {stroke:.0f} mm</source>
      <translation>{stroke:.0f} mm 上的导轨比例</translation>
    </message>
    <message>
      <source>Hand–eye</source>
      <translation>手眼</translation>
    </message>
    <message>
      <source>Hand–eye, position</source>
      <translation>手眼，位置</translation>
    </message>
    <message>
      <source>Hand–eye, rotation over {standoff:.0f} mm</source>
      <translation>手眼，{standoff:.0f} mm 上的旋转</translation>
    </message>
    <message>
      <source>Header, template…</source>
      <translation>抬头、模板…</translation>
    </message>
    <message>
      <source>Kept in this project, with a company and a logo of its own.</source>
      <translation>保存在此项目中，带自己的公司和徽标。</translation>
    </message>
    <message>
      <source>Language of the report</source>
      <translation>报告语言</translation>
    </message>
    <message>
      <source>Linear guide</source>
      <translation>直线导轨</translation>
    </message>
    <message>
      <source>Logo</source>
      <translation>徽标</translation>
    </message>
    <message>
      <source>Mean and spread over several measurements of this part</source>
      <translation>同一工件多次测量的平均值与离散</translation>
    </message>
    <message>
      <source>Measure</source>
      <translation>测量</translation>
    </message>
    <message>
      <source>Measure the distance between two points you click</source>
      <translation>测量您单击的两点之间的距离</translation>
    </message>
    <message>
      <source>Measured by</source>
      <translation>测量方式</translation>
    </message>
    <message>
      <source>Method</source>
      <translation>方法</translation>
    </message>
    <message>
      <source>Nearest point of the view</source>
      <translation>视图的最近点</translation>
    </message>
    <message>
      <source>No calibration yet</source>
      <translation>尚无标定</translation>
    </message>
    <message>
      <source>No preview.</source>
      <translation>无预览。</translation>
    </message>
    <message>
      <source>No preview. Use Open PDF to view the report.</source>
      <translation>没有预览。请用“打开 PDF”查看报告。</translation>
    </message>
    <message>
      <source>No report yet</source>
      <translation>尚无报告</translation>
    </message>
    <message>
      <source>None expected</source>
      <translation>预计没有</translation>
    </message>
    <message>
      <source>Not calibrated</source>
      <translation>未标定</translation>
    </message>
    <message>
      <source>Nothing to report.</source>
      <translation>无内容可报告。</translation>
    </message>
    <message>
      <source>Off</source>
      <translation>关</translation>
    </message>
    <message>
      <source>Open PDF</source>
      <translation>打开 PDF</translation>
    </message>
    <message>
      <source>Open a sample</source>
      <translation>打开示例</translation>
    </message>
    <message>
      <source>Opening the project…</source>
      <translation>正在打开项目…</translation>
    </message>
    <message>
      <source>PNG, JPEG or SVG</source>
      <translation>PNG、JPEG 或 SVG</translation>
    </message>
    <message>
      <source>Pair {pair}</source>
      <translation>相机对 {pair}</translation>
    </message>
    <message>
      <source>Per viewpoint</source>
      <translation>每个视点</translation>
    </message>
    <message>
      <source>Pictures (*.png *.jpg *.jpeg *.svg)</source>
      <translation>图片 (*.png *.jpg *.jpeg *.svg)</translation>
    </message>
    <message>
      <source>Pixel (row, column)</source>
      <translation>像素（行，列）</translation>
    </message>
    <message>
      <source>Poor</source>
      <translation>差</translation>
    </message>
    <message>
      <source>Poor fit: {list}. Calibrate again.</source>
      <translation>拟合差：{list}。请重新标定。</translation>
    </message>
    <message>
      <source>Position on the part</source>
      <translation>工件上的位置</translation>
    </message>
    <message>
      <source>Position {axis}</source>
      <translation>位置 {axis}</translation>
    </message>
    <message>
      <source>Positions of views are corrected for it; what the poses of the calibration did not show of it is in U</source>
      <translation>视图位置已据此修正；标定位姿未显示的部分计入 U</translation>
    </message>
    <message>
      <source>Predicted performance</source>
      <translation>预计性能</translation>
    </message>
    <message>
      <source>Preparing picks</source>
      <translation>正在准备拾取</translation>
    </message>
    <message>
      <source>Printed in the header of every document, and kept with the results of a series. Empty fields are not printed.</source>
      <translation>打印在每个文档的抬头中，并随系列结果保存。空项不打印。</translation>
    </message>
    <message>
      <source>Project</source>
      <translation>项目</translation>
    </message>
    <message>
      <source>Projector</source>
      <translation>投影仪</translation>
    </message>
    <message>
      <source>Properties</source>
      <translation>属性</translation>
    </message>
    <message>
      <source>Range</source>
      <translation>范围</translation>
    </message>
    <message>
      <source>Rendering the pages…</source>
      <translation>正在渲染页面…</translation>
    </message>
    <message>
      <source>Repeats…</source>
      <translation>重复测量…</translation>
    </message>
    <message>
      <source>Reprojection up to {reprojection_limit_px} rms</source>
      <translation>重投影不超过 {reprojection_limit_px}（均方根）</translation>
    </message>
    <message>
      <source>Residual (rms)</source>
      <translation>残差（均方根）</translation>
    </message>
    <message>
      <source>Residual up to {axis_limit_mm}</source>
      <translation>残差不超过 {axis_limit_mm}</translation>
    </message>
    <message>
      <source>Residual up to {robot_mm}, twice the robot's absolute accuracy</source>
      <translation>残差不超过 {robot_mm}，即机器人绝对精度的两倍</translation>
    </message>
    <message>
      <source>Result</source>
      <translation>结果</translation>
    </message>
    <message>
      <source>Rig</source>
      <translation>测量系统</translation>
    </message>
    <message>
      <source>Root sum of squares, as for independent solutions. They are solved together, so a part of it cancels.</source>
      <translation>平方和的根，按各解独立计算。它们一并求解，因此一部分相互抵消。</translation>
    </message>
    <message>
      <source>Rotation {axis}</source>
      <translation>旋转 {axis}</translation>
    </message>
    <message>
      <source>Second point</source>
      <translation>第二点</translation>
    </message>
    <message>
      <source>Select something to see its properties.</source>
      <translation>选择某项以查看其属性。</translation>
    </message>
    <message>
      <source>Series…</source>
      <translation>系列…</translation>
    </message>
    <message>
      <source>Set the box around everything</source>
      <translation>将盒子设为包围全部</translation>
    </message>
    <message>
      <source>Show in folder</source>
      <translation>在文件夹中显示</translation>
    </message>
    <message>
      <source>Solution</source>
      <translation>解</translation>
    </message>
    <message>
      <source>Source</source>
      <translation>来源</translation>
    </message>
    <message>
      <source>Standard deviation</source>
      <translation>标准差</translation>
    </message>
    <message>
      <source>Standard deviation σ</source>
      <translation>标准差 σ</translation>
    </message>
    <message>
      <source>Standard deviations</source>
      <translation>标准差</translation>
    </message>
    <message>
      <source>Straightness up to {robot_mm}, twice the robot's absolute accuracy</source>
      <translation>直线度不超过 {robot_mm}，即机器人绝对精度的两倍</translation>
    </message>
    <message>
      <source>Switch the clip box off; its numbers are kept</source>
      <translation>关闭裁剪盒；其数值保留</translation>
    </message>
    <message>
      <source>Table axis</source>
      <translation>转台轴线</translation>
    </message>
    <message>
      <source>Table axis, position</source>
      <translation>转台轴线，位置</translation>
    </message>
    <message>
      <source>Table axis, tilt over {height_mm:.0f} mm</source>
      <translation>{height_mm:.0f} mm 上的转台轴线倾斜</translation>
    </message>
    <message>
      <source>Template</source>
      <translation>模板</translation>
    </message>
    <message>
      <source>The board is recorded from many sides. The solutions appear here.</source>
      <translation>从多个方向拍摄标定板。解在此显示。</translation>
    </message>
    <message>
      <source>The cameras are calibrated; hand–eye, linear guide and table axis are not. Calibrate the whole rig next.</source>
      <translation>相机已标定；手眼、直线导轨和转台轴线尚未标定。接下来请标定整个测量系统。</translation>
    </message>
    <message>
      <source>The connected rig takes all images of the board itself, and everything is solved together</source>
      <translation>已连接的测量系统自行拍摄标定板的所有图像，并一并求解</translation>
    </message>
    <message>
      <source>The logo {logo} does not exist.</source>
      <translation>徽标 {logo} 不存在。</translation>
    </message>
    <message>
      <source>The report is created when a part has been measured: pictures, dimensions, calibration and settings.</source>
      <translation>工件测量后生成报告：图片、尺寸、标定和设置。</translation>
    </message>
    <message>
      <source>The report is written when the dimensions have been evaluated.</source>
      <translation>尺寸评定后生成报告。</translation>
    </message>
    <message>
      <source>The true geometry of the rig is not known yet.</source>
      <translation>测量系统的真实几何尚未知。</translation>
    </message>
    <message>
      <source>Through {vector} mm, tilted by {quantity}</source>
      <translation>通过 {vector} mm，倾斜 {quantity}</translation>
    </message>
    <message>
      <source>Time</source>
      <translation>时间</translation>
    </message>
    <message>
      <source>Together</source>
      <translation>合计</translation>
    </message>
    <message>
      <source>Trend and capability over all parts measured by one program</source>
      <translation>由同一程序测量的所有工件的趋势与能力</translation>
    </message>
    <message>
      <source>Use the calibration that was accepted without a project{words}</source>
      <translation>使用未随项目接受的标定{words}</translation>
    </message>
    <message>
      <source>Use the last one</source>
      <translation>使用上一次的</translation>
    </message>
    <message>
      <source>Verdict</source>
      <translation>判定</translation>
    </message>
    <message>
      <source>View</source>
      <translation>视图</translation>
    </message>
    <message>
      <source>Views that measured this point</source>
      <translation>测量此点的视图</translation>
    </message>
    <message>
      <source>What it holds appears here.</source>
      <translation>项目内容将显示在此处。</translation>
    </message>
    <message>
      <source>With the company and the logo below, for all your projects.</source>
      <translation>使用下面的公司和徽标，适用于您的所有项目。</translation>
    </message>
    <message>
      <source>Wrong fringe orders</source>
      <translation>条纹级次错误</translation>
    </message>
    <message>
      <source>added to a length between views (k = 2)</source>
      <translation>增加到视图间长度 (k = 2)</translation>
    </message>
    <message>
      <source>camera</source>
      <translation>相机</translation>
    </message>
    <message>
      <source>cameras</source>
      <translation>台相机</translation>
    </message>
    <message>
      <source>figure</source>
      <translation>figure</translation>
    </message>
    <message>
      <source>heading</source>
      <translation>heading</translation>
    </message>
    <message>
      <source>report templates</source>
      <translation>报告模板</translation>
    </message>
    <message>
      <source>x from</source>
      <translation>x 从</translation>
    </message>
    <message>
      <source>x to</source>
      <translation>x 至</translation>
    </message>
    <message>
      <source>y from</source>
      <translation>y 从</translation>
    </message>
    <message>
      <source>y to</source>
      <translation>y 至</translation>
    </message>
    <message>
      <source>z from</source>
      <translation>z 从</translation>
    </message>
    <message>
      <source>z to</source>
      <translation>z 至</translation>
    </message>
    <message>
      <source>{estimate}. Criterion: {criterion}.</source>
      <translation>{estimate}。准则：{criterion}。</translation>
    </message>
    <message>
      <source>{file} cannot be written.</source>
      <translation>无法写入 {file}。</translation>
    </message>
    <message>
      <source>{part_words}, measured {value}.</source>
      <translation>{part_words}，{value}测量。</translation>
    </message>
    <message>
      <source>σ of the column</source>
      <translation>列 σ</translation>
    </message>
    <message>
      <source>σ of the row</source>
      <translation>行 σ</translation>
    </message>
  </context>
  <context>
    <name>plan</name>
    <message>
      <source> % of what the rig can measure</source>
      <translation> %（测量系统可测部分）</translation>
    </message>
    <message>
      <source> viewpoints</source>
      <translation> 个视点</translation>
    </message>
    <message>
      <source>A plan lists the viewpoints of a scan. Generate one from the nominal of the part, open a file, or add viewpoints one by one.</source>
      <translation>计划列出扫描的视点。请由工件的名义模型生成、打开文件，或逐个添加视点。</translation>
    </message>
    <message>
      <source>Add a viewpoint</source>
      <translation>添加视点</translation>
    </message>
    <message>
      <source>Add on the part</source>
      <translation>在工件上添加</translation>
    </message>
    <message>
      <source>Add the present position of the connected rig</source>
      <translation>添加已连接测量系统的当前位置</translation>
    </message>
    <message>
      <source>Aim</source>
      <translation>瞄准</translation>
    </message>
    <message>
      <source>Axes</source>
      <translation>各轴</translation>
    </message>
    <message>
      <source>Azimuth</source>
      <translation>方位角</translation>
    </message>
    <message>
      <source>Azimuth, elevation, roll</source>
      <translation>方位角、仰角、滚转角</translation>
    </message>
    <message>
      <source>Begin with one viewpoint aimed at the middle of the table</source>
      <translation>从对准转台中心的一个视点开始</translation>
    </message>
    <message>
      <source>Choose patterns</source>
      <translation>选择条纹图案</translation>
    </message>
    <message>
      <source>Choose the nominal of the part</source>
      <translation>选择工件的名义模型</translation>
    </message>
    <message>
      <source>Choose the nominal of the part.</source>
      <translation>选择工件的名义模型。</translation>
    </message>
    <message>
      <source>Choose the part first.</source>
      <translation>请先选择工件。</translation>
    </message>
    <message>
      <source>Choose viewpoints by what they are predicted to measure</source>
      <translation>按预计的测量内容选择视点</translation>
    </message>
    <message>
      <source>Click the part where a new viewpoint should look.</source>
      <translation>单击工件上新视点应观察的位置。</translation>
    </message>
    <message>
      <source>Colours of the part</source>
      <translation>工件颜色</translation>
    </message>
    <message>
      <source>Coverage</source>
      <translation>覆盖率</translation>
    </message>
    <message>
      <source>Duplicate the selected rows (Ctrl+D)</source>
      <translation>复制所选行 (Ctrl+D)</translation>
    </message>
    <message>
      <source>Elevation</source>
      <translation>仰角</translation>
    </message>
    <message>
      <source>Enter the {words}.</source>
      <translation>请输入{words}。</translation>
    </message>
    <message>
      <source>Exposures of the plan</source>
      <translation>计划的曝光</translation>
    </message>
    <message>
      <source>Exposures, wait</source>
      <translation>曝光、等待</translation>
    </message>
    <message>
      <source>Flange</source>
      <translation>法兰</translation>
    </message>
    <message>
      <source>Flange x, y, z</source>
      <translation>法兰 x、y、z</translation>
    </message>
    <message>
      <source>For no rotation enter 1, 0, 0, 0.</source>
      <translation>若不旋转，请输入 1, 0, 0, 0。</translation>
    </message>
    <message>
      <source>Fringe pitches</source>
      <translation>条纹间距</translation>
    </message>
    <message>
      <source>From long to short, in ms, separated by commas</source>
      <translation>从长到短，ms，用逗号分隔</translation>
    </message>
    <message>
      <source>From long to short, in ms, separated by commas; empty: those of the plan</source>
      <translation>从长到短，ms，用逗号分隔；留空：按计划</translation>
    </message>
    <message>
      <source>Generate a plan</source>
      <translation>生成计划</translation>
    </message>
    <message>
      <source>Generate a plan…</source>
      <translation>生成计划…</translation>
    </message>
    <message>
      <source>Generate…</source>
      <translation>生成…</translation>
    </message>
    <message>
      <source>Guide, table</source>
      <translation>导轨、转台</translation>
    </message>
    <message>
      <source>How many viewpoints measure each place of the part; hatched: none</source>
      <translation>测量工件各处的视点数；阴影线：无</translation>
    </message>
    <message>
      <source>Measured {share}</source>
      <translation>已测量 {share}</translation>
    </message>
    <message>
      <source>Measures of the part</source>
      <translation>工件的量度</translation>
    </message>
    <message>
      <source>More often {percent}</source>
      <translation>多次 {percent}</translation>
    </message>
    <message>
      <source>Move</source>
      <translation>移动</translation>
    </message>
    <message>
      <source>Move down in the scan order (Alt+Down)</source>
      <translation>在扫描顺序中下移 (Alt+Down)</translation>
    </message>
    <message>
      <source>Move the robot</source>
      <translation>移动机器人</translation>
    </message>
    <message>
      <source>Move up in the scan order (Alt+Up)</source>
      <translation>在扫描顺序中上移 (Alt+Up)</translation>
    </message>
    <message>
      <source>Name of the plan</source>
      <translation>计划名称</translation>
    </message>
    <message>
      <source>Name, patterns, exposures and waiting time of the plan</source>
      <translation>计划的名称、图案、曝光和等待时间</translation>
    </message>
    <message>
      <source>No scan plan yet</source>
      <translation>尚无扫描计划</translation>
    </message>
    <message>
      <source>No scan plan.</source>
      <translation>没有扫描计划。</translation>
    </message>
    <message>
      <source>Not measured {percent}</source>
      <translation>未测量 {percent}</translation>
    </message>
    <message>
      <source>Nothing to redo</source>
      <translation>没有可重做的操作</translation>
    </message>
    <message>
      <source>Nothing to undo</source>
      <translation>没有可撤销的操作</translation>
    </message>
    <message>
      <source>Number of viewpoints</source>
      <translation>视点数量</translation>
    </message>
    <message>
      <source>Once {percent}</source>
      <translation>一次 {percent}</translation>
    </message>
    <message>
      <source>Open a plan…</source>
      <translation>打开计划…</translation>
    </message>
    <message>
      <source>Open a scan plan</source>
      <translation>打开扫描计划</translation>
    </message>
    <message>
      <source>Open a scan plan (TOML or JSON)</source>
      <translation>打开扫描计划（TOML 或 JSON）</translation>
    </message>
    <message>
      <source>Open…</source>
      <translation>打开…</translation>
    </message>
    <message>
      <source>Order all viewpoints so that the axes move least; groups are dissolved</source>
      <translation>排列所有视点，使各轴移动最少；分组会解散</translation>
    </message>
    <message>
      <source>Part…</source>
      <translation>工件…</translation>
    </message>
    <message>
      <source>Patterns</source>
      <translation>条纹图案</translation>
    </message>
    <message>
      <source>Patterns of the plan</source>
      <translation>计划的条纹图案</translation>
    </message>
    <message>
      <source>Plan</source>
      <translation>计划</translation>
    </message>
    <message>
      <source>Planning…</source>
      <translation>正在规划…</translation>
    </message>
    <message>
      <source>Position and direction of the robot's flange, as its controller states them</source>
      <translation>机器人法兰的位置和方向，按其控制器给出</translation>
    </message>
    <message>
      <source>Predicted</source>
      <translation>预计</translation>
    </message>
    <message>
      <source>Predicted coverage {predicted}</source>
      <translation>预计覆盖率 {predicted}</translation>
    </message>
    <message>
      <source>Prevents the scan</source>
      <translation>阻止扫描</translation>
    </message>
    <message>
      <source>Properties of</source>
      <translation>属性所属</translation>
    </message>
    <message>
      <source>Quaternion w, x, y, z</source>
      <translation>四元数 w、x、y、z</translation>
    </message>
    <message>
      <source>Redo</source>
      <translation>重做</translation>
    </message>
    <message>
      <source>Redo: {redotext}</source>
      <translation>重做：{redotext}</translation>
    </message>
    <message>
      <source>Remove</source>
      <translation>移除</translation>
    </message>
    <message>
      <source>Remove the selected rows (Del)</source>
      <translation>移除所选行 (Del)</translation>
    </message>
    <message>
      <source>Rename the plan</source>
      <translation>重命名计划</translation>
    </message>
    <message>
      <source>Rename {name}</source>
      <translation>重命名 {name}</translation>
    </message>
    <message>
      <source>Repeat at table angles</source>
      <translation>按转台角度重复</translation>
    </message>
    <message>
      <source>Repeat the selected viewpoints at several table angles, as a group</source>
      <translation>在多个转台角度重复所选视点，作为一组</translation>
    </message>
    <message>
      <source>Replace the selected group by its viewpoints</source>
      <translation>用所选组的视点替换该组</translation>
    </message>
    <message>
      <source>Robot pose</source>
      <translation>机器人位姿</translation>
    </message>
    <message>
      <source>Roll</source>
      <translation>滚转角</translation>
    </message>
    <message>
      <source>Save the plan as TOML or JSON</source>
      <translation>将计划保存为 TOML 或 JSON</translation>
    </message>
    <message>
      <source>Save the scan plan</source>
      <translation>保存扫描计划</translation>
    </message>
    <message>
      <source>Scan plans (*.toml *.json)</source>
      <translation>扫描计划 (*.toml *.json)</translation>
    </message>
    <message>
      <source>Scan with this plan; it is stored in the open project</source>
      <translation>按此计划扫描；它随打开的项目保存</translation>
    </message>
    <message>
      <source>Select a viewpoint to change it.</source>
      <translation>选择一个视点以更改。</translation>
    </message>
    <message>
      <source>Select a viewpoint to see its properties.</source>
      <translation>选择一个视点以查看其属性。</translation>
    </message>
    <message>
      <source>Set</source>
      <translation>设置</translation>
    </message>
    <message>
      <source>Set exposures</source>
      <translation>设置曝光</translation>
    </message>
    <message>
      <source>Set the waiting time</source>
      <translation>设置等待时间</translation>
    </message>
    <message>
      <source>Set the {words}</source>
      <translation>设置{words}</translation>
    </message>
    <message>
      <source>Set {value}</source>
      <translation>设置 {value}</translation>
    </message>
    <message>
      <source>Stand-off</source>
      <translation>工作距离</translation>
    </message>
    <message>
      <source>Table</source>
      <translation>转台</translation>
    </message>
    <message>
      <source>Table angles in degrees, separated by commas:</source>
      <translation>转台角度（度），用逗号分隔：</translation>
    </message>
    <message>
      <source>Target x, y, z</source>
      <translation>目标 x、y、z</translation>
    </message>
    <message>
      <source>The part in one colour</source>
      <translation>工件单色显示</translation>
    </message>
    <message>
      <source>The plan is being made.</source>
      <translation>正在制定计划。</translation>
    </message>
    <message>
      <source>The quaternion (w, x, y, z) is zero and names no direction.</source>
      <translation>四元数 (w, x, y, z) 为零，没有方向。</translation>
    </message>
    <message>
      <source>The scan uses this plan</source>
      <translation>扫描使用此计划</translation>
    </message>
    <message>
      <source>This viewpoint</source>
      <translation>此视点</translation>
    </message>
    <message>
      <source>Twice {percent}</source>
      <translation>两次 {percent}</translation>
    </message>
    <message>
      <source>Ungroup</source>
      <translation>取消分组</translation>
    </message>
    <message>
      <source>Until</source>
      <translation>直至</translation>
    </message>
    <message>
      <source>Use for the scan</source>
      <translation>用于扫描</translation>
    </message>
    <message>
      <source>Viewpoints are chosen by what cameras and projector are predicted to measure, and ordered so that the axes move little. The plan replaces the one shown; undo brings that back.</source>
      <translation>视点按相机和投影仪预计的测量内容选择，并按各轴移动少的顺序排列。该计划替换所显示的计划；撤销可恢复。</translation>
    </message>
    <message>
      <source>Wait</source>
      <translation>等待</translation>
    </message>
    <message>
      <source>Wait before images are taken, in s; empty: that of the plan</source>
      <translation>拍摄前等待，s；留空：按计划</translation>
    </message>
    <message>
      <source>Wait before images are taken, in s; empty: that of the rig</source>
      <translation>拍摄前等待，s；留空：按测量系统</translation>
    </message>
    <message>
      <source>Waiting time</source>
      <translation>等待时间</translation>
    </message>
    <message>
      <source>Waiting time of the plan</source>
      <translation>计划的等待时间</translation>
    </message>
    <message>
      <source>What the selected viewpoint measures; hatched: nothing</source>
      <translation>所选视点测量的部分；阴影线：无</translation>
    </message>
    <message>
      <source>Where the head looks, from which side, elevation and distance</source>
      <translation>测头观察的位置、方向、仰角和距离</translation>
    </message>
    <message>
      <source>Which no other measures</source>
      <translation>其他视点均未测量</translation>
    </message>
    <message>
      <source>Whole plan</source>
      <translation>整个计划</translation>
    </message>
    <message>
      <source>Write numbers separated by commas.</source>
      <translation>请写以逗号分隔的数字。</translation>
    </message>
    <message>
      <source>about {time_s}, {bytes}</source>
      <translation>约 {time_s}，{bytes}</translation>
    </message>
    <message>
      <source>being checked…</source>
      <translation>正在检查…</translation>
    </message>
    <message>
      <source>guide in mm</source>
      <translation>导轨（mm）</translation>
    </message>
    <message>
      <source>keep-out box</source>
      <translation>禁入区</translation>
    </message>
    <message>
      <source>nothing prevents the scan</source>
      <translation>没有问题阻止扫描</translation>
    </message>
    <message>
      <source>plan</source>
      <translation>计划</translation>
    </message>
    <message>
      <source>problems</source>
      <translation>个问题</translation>
    </message>
    <message>
      <source>rig</source>
      <translation>测量系统</translation>
    </message>
    <message>
      <source>row</source>
      <translation>行</translation>
    </message>
    <message>
      <source>rows</source>
      <translation>行</translation>
    </message>
    <message>
      <source>table in degrees</source>
      <translation>转台（度）</translation>
    </message>
    <message>
      <source>viewpoint</source>
      <translation>个视点</translation>
    </message>
    <message>
      <source>viewpoints</source>
      <translation>个视点</translation>
    </message>
    <message>
      <source>x of the flange</source>
      <translation>法兰的 x</translation>
    </message>
    <message>
      <source>x of the target</source>
      <translation>目标的 x</translation>
    </message>
    <message>
      <source>y of the flange</source>
      <translation>法兰的 y</translation>
    </message>
    <message>
      <source>y of the target</source>
      <translation>目标的 y</translation>
    </message>
    <message>
      <source>z of the flange</source>
      <translation>法兰的 z</translation>
    </message>
    <message>
      <source>z of the target</source>
      <translation>目标的 z</translation>
    </message>
    <message>
      <source>{rows} selected.</source>
      <translation>已选择 {rows}。</translation>
    </message>
    <message>
      <source>{text!r} is not a list of angles.</source>
      <translation>{text!r} 不是角度列表。</translation>
    </message>
    <message>
      <source>{text!r} is not a number.</source>
      <translation>{text!r} 不是数字。</translation>
    </message>
  </context>
  <context>
    <name>repeats</name>
    <message>
      <source>A test needs two values and a stated U</source>
      <translation>检验需要两个值和规定的 U</translation>
    </message>
    <message>
      <source>Add at least two projects with dimensions of the same inspection program.</source>
      <translation>请至少添加两个具有相同检测程序尺寸的项目。</translation>
    </message>
    <message>
      <source>Add the project of one measurement</source>
      <translation>添加一次测量的项目</translation>
    </message>
    <message>
      <source>Add…</source>
      <translation>添加…</translation>
    </message>
    <message>
      <source>Clamp again before each</source>
      <translation>每次之前重新装夹</translation>
    </message>
    <message>
      <source>Clamp the part again, then continue with measurement {number} of {count}.</source>
      <translation>请重新装夹工件，然后继续第 {number} 次测量，共 {count} 次。</translation>
    </message>
    <message>
      <source>Compare</source>
      <translation>比较</translation>
    </message>
    <message>
      <source>End</source>
      <translation>结束</translation>
    </message>
    <message>
      <source>Evaluate mean and spread</source>
      <translation>评定平均值与离散</translation>
    </message>
    <message>
      <source>Every measurement becomes a project beside the open one.</source>
      <translation>每次测量都成为打开项目旁的一个项目。</translation>
    </message>
    <message>
      <source>Folder for the report of repeats</source>
      <translation>重复测量报告的文件夹</translation>
    </message>
    <message>
      <source>Larger than U</source>
      <translation>大于 U</translation>
    </message>
    <message>
      <source>Mean</source>
      <translation>平均值</translation>
    </message>
    <message>
      <source>Mean, spread and deviation of every dimension over several measurements of one part, and whether the stated uncertainty explains the spread.</source>
      <translation>同一工件多次测量中每个尺寸的平均值、离散和偏差，以及规定的不确定度是否能解释离散。</translation>
    </message>
    <message>
      <source>Measure no further; what was measured is kept</source>
      <translation>不再测量；已测的内容保留</translation>
    </message>
    <message>
      <source>Measurement {number} of {count} is running.</source>
      <translation>正在进行第 {number} 次测量，共 {count} 次。</translation>
    </message>
    <message>
      <source>Measurements</source>
      <translation>测量</translation>
    </message>
    <message>
      <source>Measurements of one part</source>
      <translation>同一工件的测量</translation>
    </message>
    <message>
      <source>Not tested</source>
      <translation>未检验</translation>
    </message>
    <message>
      <source>One part under several names</source>
      <translation>同一工件使用了多个名称</translation>
    </message>
    <message>
      <source>Open a calibrated project with a plan to measure its part again.</source>
      <translation>打开带计划的已标定项目，以再次测量其工件。</translation>
    </message>
    <message>
      <source>PDF, table (CSV) and JSON</source>
      <translation>PDF、表格 (CSV) 和 JSON</translation>
    </message>
    <message>
      <source>Projects</source>
      <translation>项目</translation>
    </message>
    <message>
      <source>Relative</source>
      <translation>相对</translation>
    </message>
    <message>
      <source>Repeated measurements</source>
      <translation>重复测量</translation>
    </message>
    <message>
      <source>Save the report…</source>
      <translation>保存报告…</translation>
    </message>
    <message>
      <source>Spread</source>
      <translation>离散</translation>
    </message>
    <message>
      <source>Take the chosen project from the list; nothing is deleted</source>
      <translation>从列表中去掉所选项目；不会删除任何内容</translation>
    </message>
    <message>
      <source>The part is clamped; begin the measurement</source>
      <translation>工件已装夹；开始测量</translation>
    </message>
    <message>
      <source>The spread is larger than the stated U explains (chi-square test)</source>
      <translation>离散大于规定的 U 所能解释的（卡方检验）</translation>
    </message>
    <message>
      <source>The stated U explains the spread (chi-square test)</source>
      <translation>规定的 U 能解释离散（卡方检验）</translation>
    </message>
    <message>
      <source>Within U</source>
      <translation>在 U 之内</translation>
    </message>
    <message>
      <source>measurement</source>
      <translation>次测量</translation>
    </message>
    <message>
      <source>measurements</source>
      <translation>次测量</translation>
    </message>
    <message>
      <source>{count} by the program {program}. {list}</source>
      <translation>按程序 {program}，{count}。{list}</translation>
    </message>
  </context>
  <context>
    <name>rig</name>
    <message>
      <source> {count} could not be loaded.</source>
      <translation> 有 {count} 个无法加载。</translation>
    </message>
    <message>
      <source>A link is what several drivers share: a serial line, a gateway, a simulated rig. Drivers name it in their setting “Link”.</source>
      <translation>连接是多个驱动共用的：串行线、网关或模拟测量系统。驱动在其“连接”设置中指明。</translation>
    </message>
    <message>
      <source>Absolute accuracy</source>
      <translation>绝对精度</translation>
    </message>
    <message>
      <source>Add a link</source>
      <translation>添加连接</translation>
    </message>
    <message>
      <source>All devices are ready.</source>
      <translation>所有设备已就绪。</translation>
    </message>
    <message>
      <source>Allow</source>
      <translation>允许</translation>
    </message>
    <message>
      <source>Allow the driver {row.name}?
Folder: {row.folder}
Fingerprint (SHA-256): {seen}
Its code runs with your rights on this computer. If any of its files changes, you are asked again.</source>
      <translation>允许驱动 {row.name}？
文件夹：{row.folder}
指纹 (SHA-256)：{seen}
其代码以您的权限在此计算机上运行。若其任何文件更改，会再次询问。</translation>
    </message>
    <message>
      <source>Allow this driver…</source>
      <translation>允许此驱动…</translation>
    </message>
    <message>
      <source>Calibrates a virtual rig with hidden errors, scans the part, stitches the clouds, evaluates the dimensions and writes the report.</source>
      <translation>标定带隐藏误差的虚拟测量系统，扫描工件，拼接点云，评定尺寸并生成报告。</translation>
    </message>
    <message>
      <source>Calibration rules</source>
      <translation>标定规则</translation>
    </message>
    <message>
      <source>Cell</source>
      <translation>工作站</translation>
    </message>
    <message>
      <source>Choose a driver</source>
      <translation>选择驱动</translation>
    </message>
    <message>
      <source>Choose a driver.</source>
      <translation>请选择驱动。</translation>
    </message>
    <message>
      <source>Connect</source>
      <translation>连接</translation>
    </message>
    <message>
      <source>Connect every device of this rig; nothing moves</source>
      <translation>连接此测量系统的每台设备；不作任何运动</translation>
    </message>
    <message>
      <source>Connect the rig to move its axes.</source>
      <translation>连接测量系统以移动其各轴。</translation>
    </message>
    <message>
      <source>Demo</source>
      <translation>演示</translation>
    </message>
    <message>
      <source>Demo on the virtual rig</source>
      <translation>虚拟测量系统演示</translation>
    </message>
    <message>
      <source>Device</source>
      <translation>设备</translation>
    </message>
    <message>
      <source>Discard changes</source>
      <translation>放弃更改</translation>
    </message>
    <message>
      <source>Disconnect</source>
      <translation>断开</translation>
    </message>
    <message>
      <source>Driver</source>
      <translation>驱动</translation>
    </message>
    <message>
      <source>Drivers</source>
      <translation>驱动</translation>
    </message>
    <message>
      <source>Drivers of your own are folders in {folder}. The computer runs their code: allow only those whose origin you trust.</source>
      <translation>您自己的驱动是 {folder} 中的文件夹。计算机会运行其代码：只允许来源可信的驱动。</translation>
    </message>
    <message>
      <source>Drivers, settings, motion rules and nominal values of this rig</source>
      <translation>此测量系统的驱动、设置、运动规则和名义值</translation>
    </message>
    <message>
      <source>Drives</source>
      <translation>驱动器</translation>
    </message>
    <message>
      <source>Edit rig: {name}</source>
      <translation>编辑测量系统：{name}</translation>
    </message>
    <message>
      <source>Edit rig…</source>
      <translation>编辑测量系统…</translation>
    </message>
    <message>
      <source>Enter a name for each link.</source>
      <translation>请为每个连接输入名称。</translation>
    </message>
    <message>
      <source>Exposure of the live images</source>
      <translation>实时图像的曝光</translation>
    </message>
    <message>
      <source>Find references</source>
      <translation>回参考点</translation>
    </message>
    <message>
      <source>Guide and table find their reference positions</source>
      <translation>导轨和转台寻找其参考位置</translation>
    </message>
    <message>
      <source>Hold a button to move on. Stop is no safety function:
in danger use the emergency stop.</source>
      <translation>按住按钮可继续移动。“停止”不是安全功能：
危险时请使用急停。</translation>
    </message>
    <message>
      <source>Keep editing</source>
      <translation>继续编辑</translation>
    </message>
    <message>
      <source>Let the rig run again, after the cause was removed</source>
      <translation>排除原因后，让测量系统重新运行</translation>
    </message>
    <message>
      <source>Links</source>
      <translation>连接</translation>
    </message>
    <message>
      <source>Loaded</source>
      <translation>已加载</translation>
    </message>
    <message>
      <source>Loaded.</source>
      <translation>已加载。</translation>
    </message>
    <message>
      <source>Loading the rig…</source>
      <translation>正在加载测量系统…</translation>
    </message>
    <message>
      <source>Measuring head</source>
      <translation>测头</translation>
    </message>
    <message>
      <source>Model</source>
      <translation>型号</translation>
    </message>
    <message>
      <source>Motion</source>
      <translation>运动</translation>
    </message>
    <message>
      <source>Move by hand</source>
      <translation>手动移动</translation>
    </message>
    <message>
      <source>Name of the link</source>
      <translation>连接名称</translation>
    </message>
    <message>
      <source>Nominal values</source>
      <translation>名义值</translation>
    </message>
    <message>
      <source>Nominal values from data sheets. Calibration determines the true values.</source>
      <translation>名义值取自数据表。真值由标定确定。</translation>
    </message>
    <message>
      <source>Not allowed yet</source>
      <translation>尚未允许</translation>
    </message>
    <message>
      <source>Not loaded</source>
      <translation>未加载</translation>
    </message>
    <message>
      <source>One for each device</source>
      <translation>每台设备一个</translation>
    </message>
    <message>
      <source>One for the whole rig</source>
      <translation>整个测量系统一个</translation>
    </message>
    <message>
      <source>Open a rig description</source>
      <translation>打开测量系统描述</translation>
    </message>
    <message>
      <source>Open a rig description…</source>
      <translation>打开测量系统描述…</translation>
    </message>
    <message>
      <source>Panel</source>
      <translation>面板</translation>
    </message>
    <message>
      <source>Reach</source>
      <translation>工作范围</translation>
    </message>
    <message>
      <source>Reach {max_reach_mm:.0f} mm · repeatability {repeatability_mm}</source>
      <translation>工作范围 {max_reach_mm:.0f} mm · 重复精度 {repeatability_mm}</translation>
    </message>
    <message>
      <source>Recording: there are no devices</source>
      <translation>录制：没有设备</translation>
    </message>
    <message>
      <source>Release every device</source>
      <translation>释放所有设备</translation>
    </message>
    <message>
      <source>Remove the link {name}</source>
      <translation>移除连接 {name}</translation>
    </message>
    <message>
      <source>Repeatability</source>
      <translation>重复精度</translation>
    </message>
    <message>
      <source>Reset the stop before anything moves.</source>
      <translation>在任何运动之前请复位停止。</translation>
    </message>
    <message>
      <source>Rig descriptions (*.toml)</source>
      <translation>测量系统描述 (*.toml)</translation>
    </message>
    <message>
      <source>Robot</source>
      <translation>机器人</translation>
    </message>
    <message>
      <source>Rotary table</source>
      <translation>转台</translation>
    </message>
    <message>
      <source>Save the rig description</source>
      <translation>保存测量系统描述</translation>
    </message>
    <message>
      <source>Save to another file</source>
      <translation>保存到其他文件</translation>
    </message>
    <message>
      <source>Save to {file}</source>
      <translation>保存到 {file}</translation>
    </message>
    <message>
      <source>Save without comments</source>
      <translation>不带注释保存</translation>
    </message>
    <message>
      <source>Sections</source>
      <translation>章节</translation>
    </message>
    <message>
      <source>Shows its folder and fingerprint, then asks</source>
      <translation>显示其文件夹和指纹，然后询问</translation>
    </message>
    <message>
      <source>Standoff</source>
      <translation>工作距离</translation>
    </message>
    <message>
      <source>The driver has no setting {list}; it is removed when you save.</source>
      <translation>驱动没有设置 {list}；保存时将移除。</translation>
    </message>
    <message>
      <source>The rig description is being read.</source>
      <translation>正在读取测量系统描述。</translation>
    </message>
    <message>
      <source>The rig is stopped: {stopped} Remove the cause, check that nothing is in the way, then reset.</source>
      <translation>测量系统已停止：{stopped} 请排除原因，确认无障碍，然后复位。</translation>
    </message>
    <message>
      <source>The rig to work with: one that comes with the program, or a description of your own (TOML)</source>
      <translation>要使用的测量系统：程序自带的，或您自己的描述 (TOML)</translation>
    </message>
    <message>
      <source>There is no link {name}. Add it under Links.</source>
      <translation>没有连接 {name}。请在“连接”下添加。</translation>
    </message>
    <message>
      <source>There is no such driver.</source>
      <translation>没有此驱动。</translation>
    </message>
    <message>
      <source>These settings are kept as they are and checked when the rig is connected.</source>
      <translation>这些设置原样保留，连接测量系统时检查。</translation>
    </message>
    <message>
      <source>Two links have the name {twice}.</source>
      <translation>两个连接同名 {twice}。</translation>
    </message>
    <message>
      <source>Version</source>
      <translation>版本</translation>
    </message>
    <message>
      <source>Version {version}</source>
      <translation>版本 {version}</translation>
    </message>
    <message>
      <source>What was changed here is not saved yet.</source>
      <translation>此处的更改尚未保存。</translation>
    </message>
    <message>
      <source>by the program</source>
      <translation>由程序</translation>
    </message>
    <message>
      <source>by the projector</source>
      <translation>由投影仪</translation>
    </message>
    <message>
      <source>device</source>
      <translation>个设备</translation>
    </message>
    <message>
      <source>devices</source>
      <translation>个设备</translation>
    </message>
    <message>
      <source>driver</source>
      <translation>个驱动</translation>
    </message>
    <message>
      <source>drivers</source>
      <translation>个驱动</translation>
    </message>
    <message>
      <source>{count} not ready.</source>
      <translation>{count} 未就绪。</translation>
    </message>
    <message>
      <source>{low} … {high} mm · repeatability {repeatability_mm}</source>
      <translation>{low} … {high} mm · 重复精度 {repeatability_mm}</translation>
    </message>
    <message>
      <source>{name} has a size of {span:.4g}</source>
      <translation>{name} 的大小为 {span:.4g}</translation>
    </message>
    <message>
      <source>{name} has comments. Saving writes the file anew and deletes them.</source>
      <translation>{name} 有注释。保存会重写文件并删除注释。</translation>
    </message>
    <message>
      <source>{name}, connected. </source>
      <translation>{name}，已连接。</translation>
    </message>
    <message>
      <source>{name}. {count}, projector, robot, guide and table; not connected.</source>
      <translation>{name}。{count}、投影仪、机器人、导轨和转台；未连接。</translation>
    </message>
    <message>
      <source>{width_px} × {height_px} px · {focal_mm:g} mm lens · {bit_depth} bit</source>
      <translation>{width_px} × {height_px} px · {focal_mm:g} mm 镜头 · {bit_depth} 位</translation>
    </message>
    <message>
      <source>{words} Folder: {folder}</source>
      <translation>{words} 文件夹：{folder}</translation>
    </message>
    <message>
      <source>{words} – not loaded</source>
      <translation>{words} – 未加载</translation>
    </message>
    <message>
      <source>⌀ {diameter_mm:.0f} mm · accuracy {accuracy_arcsec:g}″</source>
      <translation>⌀ {diameter_mm:.0f} mm · 精度 {accuracy_arcsec:g}″</translation>
    </message>
  </context>
  <context>
    <name>scan</name>
    <message>
      <source>, at least {images_s} for the images</source>
      <translation>，图像至少 {images_s}</translation>
    </message>
    <message>
      <source>, {failed} failed</source>
      <translation>，{failed} 个失败</translation>
    </message>
    <message>
      <source>, {skipped} skipped.</source>
      <translation>，跳过 {skipped} 个。</translation>
    </message>
    <message>
      <source>, {stored} stored</source>
      <translation>，已存储 {stored}</translation>
    </message>
    <message>
      <source>A new project is made here.</source>
      <translation>在此创建新项目。</translation>
    </message>
    <message>
      <source>A probe at every viewpoint chooses its exposures; for parts with bright and dark sides</source>
      <translation>在每个视点试测选择其曝光；适用于有亮面和暗面的工件</translation>
    </message>
    <message>
      <source>A probe at the first viewpoint chooses the exposures of all</source>
      <translation>在第一个视点试测选择全部视点的曝光</translation>
    </message>
    <message>
      <source>A ready-made scan of a sample part on the virtual rig</source>
      <translation>虚拟测量系统上示例工件的现成扫描</translation>
    </message>
    <message>
      <source>A scan moves the rig from viewpoint to viewpoint, projects fringes and takes images. Choose a project and a plan, or run the demo.</source>
      <translation>扫描使测量系统在视点间移动，投射条纹并拍摄图像。请选择项目和计划，或运行演示。</translation>
    </message>
    <message>
      <source>About {expected_s} left, at most {bound_s}; then the clouds are stitched.</source>
      <translation>约剩 {expected_s}，最多 {bound_s}；随后拼接点云。</translation>
    </message>
    <message>
      <source>Add and scan them</source>
      <translation>添加并扫描</translation>
    </message>
    <message>
      <source>Add these viewpoints to the plan and take them; stored images are kept</source>
      <translation>将这些视点加入计划并拍摄；已存图像保留</translation>
    </message>
    <message>
      <source>All images are taken. The clouds are computed and stitched; Cancel keeps the images.</source>
      <translation>所有图像已拍摄。正在计算并拼接点云；“取消”会保留图像。</translation>
    </message>
    <message>
      <source>As planned</source>
      <translation>按计划</translation>
    </message>
    <message>
      <source>As the project states</source>
      <translation>按项目规定</translation>
    </message>
    <message>
      <source>As they were taken; everything can be computed again</source>
      <translation>按拍摄原样；一切都可重新计算</translation>
    </message>
    <message>
      <source>Back to viewpoints, images and clouds</source>
      <translation>回到视点、图像和点云</translation>
    </message>
    <message>
      <source>Before the scan</source>
      <translation>扫描之前</translation>
    </message>
    <message>
      <source>Calibration of</source>
      <translation>标定来源</translation>
    </message>
    <message>
      <source>Check</source>
      <translation>检查</translation>
    </message>
    <message>
      <source>Check connects the rig and lists what prevents the scan; nothing moves.</source>
      <translation>“检查”连接测量系统并列出阻止扫描的问题；不作任何运动。</translation>
    </message>
    <message>
      <source>Check, then scan if nothing prevents it</source>
      <translation>检查，若没有问题则扫描</translation>
    </message>
    <message>
      <source>Choose a rig, a project folder and a plan first</source>
      <translation>请先选择测量系统、项目文件夹和计划</translation>
    </message>
    <message>
      <source>Choose a viewpoint to see its images, to skip it or to take it again.</source>
      <translation>选择视点以查看其图像、跳过或重拍。</translation>
    </message>
    <message>
      <source>Choose project, plan and exposures of another scan</source>
      <translation>选择另一次扫描的项目、计划和曝光</translation>
    </message>
    <message>
      <source>Choose project, plan and exposures.</source>
      <translation>选择项目、计划和曝光。</translation>
    </message>
    <message>
      <source>Compare with the nominal, and propose the views that pay</source>
      <translation>与名义模型比较，并建议有价值的视图</translation>
    </message>
    <message>
      <source>Compress after the scan</source>
      <translation>扫描后压缩</translation>
    </message>
    <message>
      <source>Connect the rig and list what prevents the scan; nothing moves</source>
      <translation>连接测量系统并列出阻止扫描的问题；不作任何运动</translation>
    </message>
    <message>
      <source>Continue the paused scan</source>
      <translation>继续暂停的扫描</translation>
    </message>
    <message>
      <source>Do not take the chosen viewpoint, or the present one</source>
      <translation>不拍摄所选或当前视点</translation>
    </message>
    <message>
      <source>Drop after the scan</source>
      <translation>扫描后删除</translation>
    </message>
    <message>
      <source>Every viewpoint is stored completely or not at all.</source>
      <translation>每个视点要么完整存储，要么不存储。</translation>
    </message>
    <message>
      <source>Existing project: stored viewpoints are kept, missing ones are taken.</source>
      <translation>已有项目：保留已存视点，拍摄缺少的视点。</translation>
    </message>
    <message>
      <source>Failed viewpoints</source>
      <translation>失败的视点</translation>
    </message>
    <message>
      <source>Fix the part on the table.</source>
      <translation>将工件固定在转台上。</translation>
    </message>
    <message>
      <source>Folder of the project</source>
      <translation>项目文件夹</translation>
    </message>
    <message>
      <source>For example {value}.</source>
      <translation>例如 {value}。</translation>
    </message>
    <message>
      <source>Images of {viewpoint_id}</source>
      <translation>{viewpoint_id} 的图像</translation>
    </message>
    <message>
      <source>It must not move until the scan has ended.</source>
      <translation>扫描结束前不得移动。</translation>
    </message>
    <message>
      <source>Keep</source>
      <translation>保留</translation>
    </message>
    <message>
      <source>Keep the cell clear.</source>
      <translation>请保持工作站畅通。</translation>
    </message>
    <message>
      <source>Median standard deviation {median_sigma_mm:.4f} mm.</source>
      <translation>标准差中位数 {median_sigma_mm:.4f} mm。</translation>
    </message>
    <message>
      <source>Name of the part</source>
      <translation>工件名称</translation>
    </message>
    <message>
      <source>New folder, or an existing project</source>
      <translation>新文件夹，或已有项目</translation>
    </message>
    <message>
      <source>New projects keep the images as they were taken</source>
      <translation>新项目按拍摄原样保留图像</translation>
    </message>
    <message>
      <source>New scan…</source>
      <translation>新扫描…</translation>
    </message>
    <message>
      <source>No viewpoint or exposure within reach is expected to measure more.</source>
      <translation>可达范围内预计没有视点或曝光能测得更多。</translation>
    </message>
    <message>
      <source>No viewpoint scanned.</source>
      <translation>未扫描任何视点。</translation>
    </message>
    <message>
      <source>Nominal (CAD)</source>
      <translation>名义模型 (CAD)</translation>
    </message>
    <message>
      <source>Nominal of the part</source>
      <translation>工件的名义模型</translation>
    </message>
    <message>
      <source>None yet: choose a file, or make one on the page Plan</source>
      <translation>尚无：请选择文件，或在“计划”页制定</translation>
    </message>
    <message>
      <source>None: no comparison with CAD</source>
      <translation>无：不与 CAD 比较</translation>
    </message>
    <message>
      <source>None: no dimensions</source>
      <translation>无：没有尺寸</translation>
    </message>
    <message>
      <source>Nothing has been checked yet.</source>
      <translation>尚未检查。</translation>
    </message>
    <message>
      <source>Nothing prevents the scan.</source>
      <translation>没有问题阻止扫描。</translation>
    </message>
    <message>
      <source>Nothing scanned yet</source>
      <translation>尚未扫描</translation>
    </message>
    <message>
      <source>Once their clouds are stored; clouds cannot be computed again, for example with a new calibration</source>
      <translation>存储点云之后；点云将无法重新计算，例如用新的标定</translation>
    </message>
    <message>
      <source>Pause as soon as the rig is safe; nothing stored is lost</source>
      <translation>测量系统安全后立即暂停；已存内容不会丢失</translation>
    </message>
    <message>
      <source>Paused.</source>
      <translation>已暂停。</translation>
    </message>
    <message>
      <source>Pausing: the rig comes to a safe stop…</source>
      <translation>正在暂停：测量系统正在安全停止…</translation>
    </message>
    <message>
      <source>Plan of the page Plan</source>
      <translation>“计划”页的计划</translation>
    </message>
    <message>
      <source>Probe at every viewpoint</source>
      <translation>在每个视点试测</translation>
    </message>
    <message>
      <source>Probe at the first viewpoint</source>
      <translation>在第一个视点试测</translation>
    </message>
    <message>
      <source>Program</source>
      <translation>程序</translation>
    </message>
    <message>
      <source>Project whose calibration is used</source>
      <translation>使用其标定的项目</translation>
    </message>
    <message>
      <source>Project with a calibration of this rig</source>
      <translation>带此测量系统标定的项目</translation>
    </message>
    <message>
      <source>Raw images</source>
      <translation>原始图像</translation>
    </message>
    <message>
      <source>Recompute everything from the stored images</source>
      <translation>由已存图像重新计算全部</translation>
    </message>
    <message>
      <source>Resume</source>
      <translation>继续</translation>
    </message>
    <message>
      <source>Resume the scan</source>
      <translation>继续扫描</translation>
    </message>
    <message>
      <source>Retake</source>
      <translation>重拍</translation>
    </message>
    <message>
      <source>Scan plan</source>
      <translation>扫描计划</translation>
    </message>
    <message>
      <source>See the clouds</source>
      <translation>查看点云</translation>
    </message>
    <message>
      <source>Set up a scan</source>
      <translation>设置扫描</translation>
    </message>
    <message>
      <source>Show the scan</source>
      <translation>显示扫描</translation>
    </message>
    <message>
      <source>Skip</source>
      <translation>跳过</translation>
    </message>
    <message>
      <source>Skipped viewpoints</source>
      <translation>跳过的视点</translation>
    </message>
    <message>
      <source>So far</source>
      <translation>至今</translation>
    </message>
    <message>
      <source>Start the scan</source>
      <translation>开始扫描</translation>
    </message>
    <message>
      <source>Stop (Esc) is no safety function: in danger use the emergency stop.</source>
      <translation>停止 (Esc) 不是安全功能：危险时请使用急停。</translation>
    </message>
    <message>
      <source>Stored</source>
      <translation>已存储</translation>
    </message>
    <message>
      <source>Take the chosen viewpoint again; its images are kept until the new ones are stored</source>
      <translation>重拍所选视点；新图像存储前保留旧图像</translation>
    </message>
    <message>
      <source>The exposures of the plan, the same or chosen for every viewpoint there</source>
      <translation>计划的曝光，每个视点相同或在该处选择</translation>
    </message>
    <message>
      <source>The rig is being prepared…</source>
      <translation>正在准备测量系统…</translation>
    </message>
    <message>
      <source>The viewpoints appear here when the scan begins.</source>
      <translation>扫描开始后在此显示视点。</translation>
    </message>
    <message>
      <source>Time for each</source>
      <translation>每项用时</translation>
    </message>
    <message>
      <source>Time for the exposures of one viewpoint</source>
      <translation>一个视点的曝光时间</translation>
    </message>
    <message>
      <source>What is missing</source>
      <translation>缺少的部分</translation>
    </message>
    <message>
      <source>What is missing…</source>
      <translation>缺少的部分…</translation>
    </message>
    <message>
      <source>With all of them {expected} are expected.</source>
      <translation>包含全部后预计 {expected}。</translation>
    </message>
    <message>
      <source>Without loss; everything can be computed again</source>
      <translation>无损；一切都可重新计算</translation>
    </message>
    <message>
      <source>viewpoint is</source>
      <translation>个视点</translation>
    </message>
    <message>
      <source>viewpoints are</source>
      <translation>个视点</translation>
    </message>
    <message>
      <source>{count} stored already and kept.</source>
      <translation>已存储并保留 {count}。</translation>
    </message>
    <message>
      <source>{count} stored and kept, {count_2} missing are taken</source>
      <translation>已存储并保留 {count}，拍摄缺少的 {count_2}</translation>
    </message>
    <message>
      <source>{done} of {count} processed</source>
      <translation>已处理 {done}/{count}</translation>
    </message>
    <message>
      <source>{id} is chosen.</source>
      <translation>已选择 {id}。</translation>
    </message>
    <message>
      <source>{id}: + {share} in {seconds}.</source>
      <translation>{id}：+ {share}，{seconds}。</translation>
    </message>
    <message>
      <source>{most} decoded</source>
      <translation>已解码 {most}</translation>
    </message>
    <message>
      <source>{name} with {count}</source>
      <translation>{name}，含 {count}</translation>
    </message>
    <message>
      <source>{name}, connected</source>
      <translation>{name}，已连接</translation>
    </message>
    <message>
      <source>{name}, connected by Check or Start</source>
      <translation>{name}，按“检查”或“开始”时连接</translation>
    </message>
    <message>
      <source>{share} is missing: {words}.</source>
      <translation>缺少 {share}：{words}。</translation>
    </message>
    <message>
      <source>{split}–{most} decoded</source>
      <translation>已解码 {split}–{most}</translation>
    </message>
    <message>
      <source>{sufficient} of the surface is measured, of {accessible} that does not touch the support.</source>
      <translation>已测量表面的 {sufficient}，不接触支承的部分为 {accessible}。</translation>
    </message>
  </context>
  <context>
    <name>second_screen</name>
    <message>
      <source>Connect it again, then connect the rig again.</source>
      <translation>请重新接上，然后重新连接测量系统。</translation>
    </message>
    <message>
      <source>Load the pattern set first.</source>
      <translation>请先加载图案集。</translation>
    </message>
    <message>
      <source>Name manufacturer, model or serial number too.</source>
      <translation>请同时说明制造商、型号或序列号。</translation>
    </message>
    <message>
      <source>Patterns on a second screen.</source>
      <translation>第二屏幕上的图案。</translation>
    </message>
    <message>
      <source>Set the scaling of this screen to 100 %.</source>
      <translation>将此屏幕的缩放设为 100 %。</translation>
    </message>
    <message>
      <source>Switch the projector on, and check its cable and its name.</source>
      <translation>打开投影仪，检查其电缆和名称。</translation>
    </message>
    <message>
      <source>Use driver and window of the same version.</source>
      <translation>请使用同一版本的驱动和窗口。</translation>
    </message>
    <message>
      <source>any name</source>
      <translation>任意名称</translation>
    </message>
    <message>
      <source>cover a screen and follow the commands on the standard input</source>
      <translation>覆盖一个屏幕并执行标准输入的命令</translation>
    </message>
    <message>
      <source>of the patterns, px</source>
      <translation>图案的间距，px</translation>
    </message>
    <message>
      <source>print the screens</source>
      <translation>打印屏幕列表</translation>
    </message>
    <message>
      <source>python -m ui.second_screen</source>
      <translation>python -m ui.second_screen</translation>
    </message>
  </context>
  <context>
    <name>series</name>
    <message>
      <source>95 % interval; σ from {sigma_from}. {remark}</source>
      <translation>95 % 区间；σ 来自 {sigma_from}。{remark}</translation>
    </message>
    <message>
      <source>Add the open measurement to the series of its program</source>
      <translation>将打开的测量加入其程序的系列</translation>
    </message>
    <message>
      <source>Add this measurement</source>
      <translation>添加此测量</translation>
    </message>
    <message>
      <source>Folder for the report of the series</source>
      <translation>系列报告的文件夹</translation>
    </message>
    <message>
      <source>No series yet. Operator mode files every part; a measurement that is open here is added by the button below.</source>
      <translation>尚无系列。操作模式会归档每个工件；此处打开的测量可用下面的按钮添加。</translation>
    </message>
    <message>
      <source>Overall</source>
      <translation>总体</translation>
    </message>
    <message>
      <source>PDF with run charts, table (CSV) and JSON</source>
      <translation>带运行图的 PDF、表格 (CSV) 和 JSON</translation>
    </message>
    <message>
      <source>Parts</source>
      <translation>工件</translation>
    </message>
    <message>
      <source>Reason, if this part was measured before</source>
      <translation>若此工件此前已测量，请说明原因</translation>
    </message>
    <message>
      <source>Series of parts</source>
      <translation>工件系列</translation>
    </message>
    <message>
      <source>Trend and capability of every dimension over all parts that were measured by one program.</source>
      <translation>同一程序测量的所有工件中每个尺寸的趋势与能力。</translation>
    </message>
    <message>
      <source>Within</source>
      <translation>组内</translation>
    </message>
    <message>
      <source>field</source>
      <translation>field</translation>
    </message>
    <message>
      <source>no verdict</source>
      <translation>不作判定</translation>
    </message>
    <message>
      <source>run</source>
      <translation>次测量</translation>
    </message>
    <message>
      <source>runs</source>
      <translation>次测量</translation>
    </message>
    <message>
      <source>{count} by the program {program}: {counts}.</source>
      <translation>按程序 {program}，{count}：{counts}。</translation>
    </message>
  </context>
  <context>
    <name>session</name>
    <message>
      <source>Wait until it has finished, or cancel it.</source>
      <translation>请等待其完成，或取消。</translation>
    </message>
    <message>
      <source>{busy_with} is still running.</source>
      <translation>{busy_with}仍在运行。</translation>
    </message>
  </context>
  <context>
    <name>shell</name>
    <message>
      <source>A STEP file is a nominal. Open a measured project first.</source>
      <translation>STEP 文件是名义模型。请先打开已测量的项目。</translation>
    </message>
    <message>
      <source>A tour in seven steps leads through a part that has been measured on the virtual rig, up to its report. Nothing moves.</source>
      <translation>分七步的导览，以一个在虚拟测量系统上测得的工件为例，直到其报告。不作任何运动。</translation>
    </message>
    <message>
      <source>All views in one frame. Turn the part with the left mouse button; click a point to see where it comes from.</source>
      <translation>所有视图在同一坐标系中。用鼠标左键旋转工件；单击一点可查看其来源。</translation>
    </message>
    <message>
      <source>Cameras, projector, robot, linear guide and rotary table, real or virtual. Connect them here, and move them by hand.</source>
      <translation>相机、投影仪、机器人、直线导轨和转台，真实或虚拟。在此连接并手动移动。</translation>
    </message>
    <message>
      <source>Cancel the running job</source>
      <translation>取消正在运行的任务</translation>
    </message>
    <message>
      <source>Change between light and dark</source>
      <translation>切换浅色与深色</translation>
    </message>
    <message>
      <source>Choose a template</source>
      <translation>选择模板</translation>
    </message>
    <message>
      <source>Choose another file.</source>
      <translation>请选择其他文件。</translation>
    </message>
    <message>
      <source>Choose another folder.</source>
      <translation>请选择其他文件夹。</translation>
    </message>
    <message>
      <source>Choose its nominal or inspection program</source>
      <translation>选择其名义模型或检测程序</translation>
    </message>
    <message>
      <source>Choose the cloud or mesh to inspect</source>
      <translation>选择要检测的点云或网格</translation>
    </message>
    <message>
      <source>Close project</source>
      <translation>关闭项目</translation>
    </message>
    <message>
      <source>Clouds and meshes (*.ply *.stl *.obj *.pcd *.xyz *.txt *.csv *.asc *.pts)</source>
      <translation>点云和网格 (*.ply *.stl *.obj *.pcd *.xyz *.txt *.csv *.asc *.pts)</translation>
    </message>
    <message>
      <source>Commands…</source>
      <translation>命令…</translation>
    </message>
    <message>
      <source>Create the project in a new folder</source>
      <translation>在新文件夹中创建项目</translation>
    </message>
    <message>
      <source>Ctrl+,</source>
      <translation>Ctrl+,</translation>
    </message>
    <message>
      <source>Ctrl+{value}</source>
      <translation>Ctrl+{value}</translation>
    </message>
    <message>
      <source>Delete the selected dimensions</source>
      <translation>删除所选尺寸</translation>
    </message>
    <message>
      <source>Delete the viewpoints</source>
      <translation>删除视点</translation>
    </message>
    <message>
      <source>Dimensions with tolerance, uncertainty and verdict, the worst first, and the deviation from the CAD model in colours.</source>
      <translation>带公差、不确定度和判定的尺寸，最差的在前，以及以颜色显示的与 CAD 模型的偏差。</translation>
    </message>
    <message>
      <source>Discard the edits</source>
      <translation>放弃编辑</translation>
    </message>
    <message>
      <source>Drop one file or folder at a time.</source>
      <translation>一次只拖放一个文件或文件夹。</translation>
    </message>
    <message>
      <source>Duplicate the selected dimensions</source>
      <translation>复制所选尺寸</translation>
    </message>
    <message>
      <source>Duplicate the viewpoints</source>
      <translation>复制视点</translation>
    </message>
    <message>
      <source>Esc</source>
      <translation>Esc</translation>
    </message>
    <message>
      <source>Exit</source>
      <translation>退出</translation>
    </message>
    <message>
      <source>Finish</source>
      <translation>完成</translation>
    </message>
    <message>
      <source>Free space at {folder}</source>
      <translation>{folder} 的可用空间</translation>
    </message>
    <message>
      <source>Go to the page Clouds first.</source>
      <translation>请先到“点云”页。</translation>
    </message>
    <message>
      <source>Go to the page Inspect first.</source>
      <translation>请先到“检测”页。</translation>
    </message>
    <message>
      <source>Go to the page Plan first.</source>
      <translation>请先到“计划”页。</translation>
    </message>
    <message>
      <source>Go to {word}</source>
      <translation>转到{word}</translation>
    </message>
    <message>
      <source>Help for this page</source>
      <translation>本页帮助</translation>
    </message>
    <message>
      <source>Inspect a cloud or mesh…</source>
      <translation>检测点云或网格…</translation>
    </message>
    <message>
      <source>MeasureApp cannot use {name}. Drop a project folder, a cloud, a mesh, a nominal, a rig, a plan or a program.</source>
      <translation>MeasureApp 无法使用 {name}。请拖放项目文件夹、点云、网格、名义模型、测量系统、计划或程序。</translation>
    </message>
    <message>
      <source>Messages</source>
      <translation>消息</translation>
    </message>
    <message>
      <source>Move the selected dimensions down</source>
      <translation>下移所选尺寸</translation>
    </message>
    <message>
      <source>Move the selected dimensions up</source>
      <translation>上移所选尺寸</translation>
    </message>
    <message>
      <source>Move the viewpoints down</source>
      <translation>下移视点</translation>
    </message>
    <message>
      <source>Move the viewpoints up</source>
      <translation>上移视点</translation>
    </message>
    <message>
      <source>New project from a template…</source>
      <translation>从模板新建项目…</translation>
    </message>
    <message>
      <source>New project…</source>
      <translation>新建项目…</translation>
    </message>
    <message>
      <source>Next: {lower}</source>
      <translation>下一步：{lower}</translation>
    </message>
    <message>
      <source>No job is running.</source>
      <translation>没有正在运行的任务。</translation>
    </message>
    <message>
      <source>No part has been measured.</source>
      <translation>尚未测量工件。</translation>
    </message>
    <message>
      <source>Nominals and inspection programs (*.stl *.ply *.obj *.step *.stp *.toml)</source>
      <translation>名义模型和检测程序 (*.stl *.ply *.obj *.step *.stp *.toml)</translation>
    </message>
    <message>
      <source>One automatic run calibrates the whole rig. The page states what the calibration adds to a length, and when it is due again.</source>
      <translation>一次自动运行标定整个测量系统。该页说明标定给长度增加多少不确定度，以及下次标定的时间。</translation>
    </message>
    <message>
      <source>Open a project folder</source>
      <translation>打开项目文件夹</translation>
    </message>
    <message>
      <source>Open a sample: {words}</source>
      <translation>打开示例：{words}</translation>
    </message>
    <message>
      <source>Open a scan plan…</source>
      <translation>打开扫描计划…</translation>
    </message>
    <message>
      <source>Open project…</source>
      <translation>打开项目…</translation>
    </message>
    <message>
      <source>Open recent</source>
      <translation>最近打开</translation>
    </message>
    <message>
      <source>Part programs are chosen in operator mode, from the folder of part programs.</source>
      <translation>工件程序在操作模式中从工件程序文件夹选择。</translation>
    </message>
    <message>
      <source>Part: {part_words}</source>
      <translation>工件：{part_words}</translation>
    </message>
    <message>
      <source>Python {split}</source>
      <translation>Python {split}</translation>
    </message>
    <message>
      <source>Reading versions and graphics</source>
      <translation>正在读取版本和图形信息</translation>
    </message>
    <message>
      <source>Recompute from the stored images</source>
      <translation>由已存图像重新计算</translation>
    </message>
    <message>
      <source>Redo the change of the plan</source>
      <translation>重做计划更改</translation>
    </message>
    <message>
      <source>Redo the change of the program</source>
      <translation>重做对程序的更改</translation>
    </message>
    <message>
      <source>Rename the selected feature…</source>
      <translation>重命名所选特征…</translation>
    </message>
    <message>
      <source>Save a copy as…</source>
      <translation>另存副本…</translation>
    </message>
    <message>
      <source>Save a copy of the project as</source>
      <translation>将项目副本另存为</translation>
    </message>
    <message>
      <source>Save as a template…</source>
      <translation>保存为模板…</translation>
    </message>
    <message>
      <source>Save log for support…</source>
      <translation>保存支持日志…</translation>
    </message>
    <message>
      <source>Save program with results and report</source>
      <translation>保存程序、结果和报告</translation>
    </message>
    <message>
      <source>Save the project as a template</source>
      <translation>将项目保存为模板</translation>
    </message>
    <message>
      <source>Search the dimensions</source>
      <translation>搜索尺寸</translation>
    </message>
    <message>
      <source>Select dimensions in the table first.</source>
      <translation>请先在表格中选择尺寸。</translation>
    </message>
    <message>
      <source>Select one feature in the table first.</source>
      <translation>请先在表格中选择一个特征。</translation>
    </message>
    <message>
      <source>Settings…</source>
      <translation>设置…</translation>
    </message>
    <message>
      <source>Show me a measured part</source>
      <translation>显示一个已测工件</translation>
    </message>
    <message>
      <source>Show or hide the properties</source>
      <translation>显示或隐藏属性</translation>
    </message>
    <message>
      <source>Start takes all viewpoints while the cloud grows. This one is finished: every viewpoint is a tile.</source>
      <translation>“开始”拍摄所有视点，点云随之增长。这里已完成：每个视点是一个方块。</translation>
    </message>
    <message>
      <source>Stay here</source>
      <translation>留在此处</translation>
    </message>
    <message>
      <source>Stop all axes, lamps and cameras</source>
      <translation>停止所有轴、灯和相机</translation>
    </message>
    <message>
      <source>Stopped</source>
      <translation>已停止</translation>
    </message>
    <message>
      <source>Take the tour</source>
      <translation>开始导览</translation>
    </message>
    <message>
      <source>Templates and part programs (*.mpart)</source>
      <translation>模板和工件程序 (*.mpart)</translation>
    </message>
    <message>
      <source>The clouds</source>
      <translation>点云</translation>
    </message>
    <message>
      <source>The measurement has nothing of this kind.</source>
      <translation>测量结果中没有此类内容。</translation>
    </message>
    <message>
      <source>The project {name} is opened</source>
      <translation>项目 {name} 已打开</translation>
    </message>
    <message>
      <source>The report</source>
      <translation>报告</translation>
    </message>
    <message>
      <source>The rig</source>
      <translation>测量系统</translation>
    </message>
    <message>
      <source>The rig {name} is chosen</source>
      <translation>已选择测量系统 {name}</translation>
    </message>
    <message>
      <source>The scan</source>
      <translation>扫描</translation>
    </message>
    <message>
      <source>The scan plan</source>
      <translation>扫描计划</translation>
    </message>
    <message>
      <source>The scan plan {name} is opened</source>
      <translation>扫描计划 {name} 已打开</translation>
    </message>
    <message>
      <source>The viewpoints around the part. They can be generated from its CAD model, checked and edited here.</source>
      <translation>工件周围的视点。可在此由 CAD 模型生成、检查和编辑。</translation>
    </message>
    <message>
      <source>This is an inspection program. Open a measured project first.</source>
      <translation>这是检测程序。请先打开已测量的项目。</translation>
    </message>
    <message>
      <source>This page belongs to the engineer's role.</source>
      <translation>此页属于工程师角色。</translation>
    </message>
    <message>
      <source>Undo the change of the plan</source>
      <translation>撤销计划更改</translation>
    </message>
    <message>
      <source>Undo the change of the program</source>
      <translation>撤销对程序的更改</translation>
    </message>
    <message>
      <source>Undo the last choice or filter</source>
      <translation>撤销上一次选择或滤波</translation>
    </message>
    <message>
      <source>Welcome to MeasureApp</source>
      <translation>欢迎使用 MeasureApp</translation>
    </message>
    <message>
      <source>What you see is the PDF. Export it, or put your company and logo on it. To measure a part of your own, begin on the page Rig.</source>
      <translation>您看到的是 PDF。可将其导出，或加上您的公司和徽标。要测量自己的工件，请从“测量系统”页开始。</translation>
    </message>
    <message>
      <source>Writing the file</source>
      <translation>正在写入文件</translation>
    </message>
    <message>
      <source>create make folder</source>
      <translation>新建 创建 文件夹</translation>
    </message>
    <message>
      <source>dimension feature program</source>
      <translation>尺寸 特征 程序</translation>
    </message>
    <message>
      <source>example project learn</source>
      <translation>示例 项目 学习</translation>
    </message>
    <message>
      <source>export save file report document excel</source>
      <translation>导出 保存 文件 报告 文档 表格 打印</translation>
    </message>
    <message>
      <source>first start introduction guide learn</source>
      <translation>首次启动 介绍 指南 学习</translation>
    </message>
    <message>
      <source>folder load</source>
      <translation>文件夹 加载</translation>
    </message>
    <message>
      <source>gear, one dimension is not proven</source>
      <translation>齿轮，一个尺寸未证实</translation>
    </message>
    <message>
      <source>gypsum cross, all dimensions pass</source>
      <translation>石膏十字，所有尺寸合格</translation>
    </message>
    <message>
      <source>halt emergency</source>
      <translation>停机 紧急</translation>
    </message>
    <message>
      <source>keyboard keys list</source>
      <translation>键盘 按键 列表</translation>
    </message>
    <message>
      <source>language theme preferences options</source>
      <translation>语言 主题 首选项 选项 界面</translation>
    </message>
    <message>
      <source>manual documentation</source>
      <translation>手册 文档</translation>
    </message>
    <message>
      <source>mpart new</source>
      <translation>工件程序 新建</translation>
    </message>
    <message>
      <source>page board lens hand-eye axis guide uncertainty</source>
      <translation>页面 标定板 镜头 手眼 轴线 导轨 不确定度</translation>
    </message>
    <message>
      <source>page devices drivers connect camera robot projector</source>
      <translation>页面 设备 驱动 连接 相机 机器人 投影仪</translation>
    </message>
    <message>
      <source>page dimension tolerance feature datum alignment deviation colour scale section delete nominal program</source>
      <translation>页面 尺寸 公差 特征 基准 对齐 偏差 颜色 色标 比例 截面 删除 名义 程序</translation>
    </message>
    <message>
      <source>page measure start run capture exposure</source>
      <translation>页面 测量 开始 运行 采集 曝光</translation>
    </message>
    <message>
      <source>page pdf export document print series repeats header template</source>
      <translation>页面 PDF 导出 文档 打印 系列 重复测量 报告抬头 模板</translation>
    </message>
    <message>
      <source>page viewpoints coverage path collision delete</source>
      <translation>页面 视点 覆盖率 路径 碰撞 删除</translation>
    </message>
    <message>
      <source>page views points stitch register mesh holes filter</source>
      <translation>页面 视图 点云 拼接 配准 网格 孔洞 滤波</translation>
    </message>
    <message>
      <source>panel side</source>
      <translation>面板 侧栏</translation>
    </message>
    <message>
      <source>part program mpart</source>
      <translation>工件程序 mpart</translation>
    </message>
    <message>
      <source>ply stl file compare</source>
      <translation>ply stl 文件 比较</translation>
    </message>
    <message>
      <source>process again</source>
      <translation>再次 处理</translation>
    </message>
    <message>
      <source>quit end</source>
      <translation>退出 结束</translation>
    </message>
    <message>
      <source>save as duplicate</source>
      <translation>另存 复制</translation>
    </message>
    <message>
      <source>search find palette</source>
      <translation>搜索 查找 命令面板</translation>
    </message>
    <message>
      <source>stop abort</source>
      <translation>停止 中止</translation>
    </message>
    <message>
      <source>support zip versions</source>
      <translation>支持 zip 版本</translation>
    </message>
    <message>
      <source>theme night dark light colours appearance</source>
      <translation>主题 夜间 深色 浅色 颜色 外观</translation>
    </message>
    <message>
      <source>view exclude</source>
      <translation>视图 排除</translation>
    </message>
    <message>
      <source>virtual rig sample example</source>
      <translation>虚拟 测量系统 示例</translation>
    </message>
    <message>
      <source>warnings errors log</source>
      <translation>警告 错误 日志</translation>
    </message>
    <message>
      <source>{count} not ready</source>
      <translation>{count} 未就绪</translation>
    </message>
    <message>
      <source>{drivers} failed</source>
      <translation>{drivers}失败</translation>
    </message>
    <message>
      <source>{file} cannot be written: {value}.</source>
      <translation>无法写入 {file}：{value}。</translation>
    </message>
    <message>
      <source>{name} becomes the inspection program of the project</source>
      <translation>{name} 成为项目的检测程序</translation>
    </message>
    <message>
      <source>{name} becomes the nominal of the project</source>
      <translation>{name} 成为项目的名义模型</translation>
    </message>
    <message>
      <source>{name} cannot be read: {error}.</source>
      <translation>无法读取 {name}：{error}。</translation>
    </message>
    <message>
      <source>{name} is inspected</source>
      <translation>{name} 已检测</translation>
    </message>
    <message>
      <source>{name} is neither a rig, a scan plan nor an inspection program.</source>
      <translation>{name} 既不是测量系统、扫描计划，也不是检测程序。</translation>
    </message>
    <message>
      <source>{name} is not a MeasureApp project.</source>
      <translation>{name} 不是 MeasureApp 项目。</translation>
    </message>
    <message>
      <source>{name} is not installed</source>
      <translation>未安装 {name}</translation>
    </message>
    <message>
      <source>{name}, not connected</source>
      <translation>{name}，未连接</translation>
    </message>
    <message>
      <source>{running} is still running. Wait until it has finished, or cancel it.</source>
      <translation>{running}仍在运行。请等待其完成，或取消。</translation>
    </message>
    <message>
      <source>{size} free</source>
      <translation>可用 {size}</translation>
    </message>
  </context>
  <context>
    <name>viewport</name>
    <message>
      <source>3-D view</source>
      <translation>三维视图</translation>
    </message>
    <message>
      <source>Above</source>
      <translation>高于</translation>
    </message>
    <message>
      <source>Axes, cube, scale and legend</source>
      <translation>坐标轴、立方体、比例尺和图例</translation>
    </message>
    <message>
      <source>Backend: {choose_backend}</source>
      <translation>后端：{choose_backend}</translation>
    </message>
    <message>
      <source>Below</source>
      <translation>低于</translation>
    </message>
    <message>
      <source>Blue – white – red</source>
      <translation>蓝 – 白 – 红</translation>
    </message>
    <message>
      <source>Bottom</source>
      <translation>底</translation>
    </message>
    <message>
      <source>Class: {getclassname}</source>
      <translation>类别：{getclassname}</translation>
    </message>
    <message>
      <source>Clipped</source>
      <translation>已裁剪</translation>
    </message>
    <message>
      <source>Colour scale</source>
      <translation>色标</translation>
    </message>
    <message>
      <source>Colour-blind-safe</source>
      <translation>色盲友好</translation>
    </message>
    <message>
      <source>Continuous</source>
      <translation>连续</translation>
    </message>
    <message>
      <source>Copy picture</source>
      <translation>复制图片</translation>
    </message>
    <message>
      <source>Down</source>
      <translation>下</translation>
    </message>
    <message>
      <source>F shows everything, Shift+F the selection, 1 to 7 the standard views. P changes the projection, E shows edges, T makes the surface transparent, L hides labels, H the furniture. Arrow keys rotate, with Shift they pan; plus and minus zoom. Enter picks the point in the centre.</source>
      <translation>F 显示全部，Shift+F 显示所选，1 至 7 为标准视图。P 切换投影，E 显示边线，T 使表面透明，L 隐藏标签，H 隐藏附件。方向键旋转，加 Shift 平移；加号和减号缩放。Enter 拾取中心处的点。</translation>
    </message>
    <message>
      <source>Front</source>
      <translation>前</translation>
    </message>
    <message>
      <source>Go / no-go</source>
      <translation>合格/不合格</translation>
    </message>
    <message>
      <source>Home</source>
      <translation>主页</translation>
    </message>
    <message>
      <source>Inside</source>
      <translation>公差内</translation>
    </message>
    <message>
      <source>Isometric</source>
      <translation>等轴测</translation>
    </message>
    <message>
      <source>Left</source>
      <translation>左</translation>
    </message>
    <message>
      <source>No data</source>
      <translation>无数据</translation>
    </message>
    <message>
      <source>No graphics library was found. Backend: {choose_backend}.</source>
      <translation>未找到图形库。后端：{choose_backend}。</translation>
    </message>
    <message>
      <source>OpenGL renderer</source>
      <translation>OpenGL 渲染器</translation>
    </message>
    <message>
      <source>OpenGL vendor</source>
      <translation>OpenGL 供应商</translation>
    </message>
    <message>
      <source>OpenGL version</source>
      <translation>OpenGL 版本</translation>
    </message>
    <message>
      <source>Parallel projection</source>
      <translation>平行投影</translation>
    </message>
    <message>
      <source>Preparing 3-D view…</source>
      <translation>正在准备三维视图…</translation>
    </message>
    <message>
      <source>Rainbow with green band</source>
      <translation>带绿色带的彩虹</translation>
    </message>
    <message>
      <source>Rear</source>
      <translation>后</translation>
    </message>
    <message>
      <source>Return</source>
      <translation>回车</translation>
    </message>
    <message>
      <source>Right</source>
      <translation>右</translation>
    </message>
    <message>
      <source>Rotate about this place</source>
      <translation>绕此处旋转</translation>
    </message>
    <message>
      <source>Save picture</source>
      <translation>保存图片</translation>
    </message>
    <message>
      <source>Save picture for print…</source>
      <translation>保存打印图片…</translation>
    </message>
    <message>
      <source>Save picture without background…</source>
      <translation>保存无背景图片…</translation>
    </message>
    <message>
      <source>Show everything</source>
      <translation>显示全部</translation>
    </message>
    <message>
      <source>Showing {shown} of {total} points</source>
      <translation>显示 {total} 个点中的 {shown} 个</translation>
    </message>
    <message>
      <source>Showing {value:.1f} of {value_2:.1f} million points</source>
      <translation>显示 {value_2:.1f} 百万点中的 {value:.1f} 百万点</translation>
    </message>
    <message>
      <source>Simplified while turning</source>
      <translation>旋转时简化</translation>
    </message>
    <message>
      <source>Standard views</source>
      <translation>标准视图</translation>
    </message>
    <message>
      <source>Steps</source>
      <translation>级数</translation>
    </message>
    <message>
      <source>Swap colours</source>
      <translation>交换颜色</translation>
    </message>
    <message>
      <source>Symmetric range</source>
      <translation>对称范围</translation>
    </message>
    <message>
      <source>The 3-D view needs a graphics library that is not installed. See Help, Scan: “If the 3-D view stays empty”.</source>
      <translation>三维视图需要未安装的图形库。请见帮助“扫描”：“若三维视图为空”。</translation>
    </message>
    <message>
      <source>The 3-D view needs a library that is missing ({error}). Run the installer again.</source>
      <translation>三维视图缺少所需的库 ({error})。请重新运行安装程序。</translation>
    </message>
    <message>
      <source>Top</source>
      <translation>顶</translation>
    </message>
    <message>
      <source>Transparent surface</source>
      <translation>透明表面</translation>
    </message>
    <message>
      <source>Up</source>
      <translation>上</translation>
    </message>
    <message>
      <source>Value of the legend</source>
      <translation>图例的值</translation>
    </message>
    <message>
      <source>basic render</source>
      <translation>basic render</translation>
    </message>
    <message>
      <source>gdi generic</source>
      <translation>gdi generic</translation>
    </message>
    <message>
      <source>tolerance high</source>
      <translation>公差上限</translation>
    </message>
    <message>
      <source>tolerance low</source>
      <translation>公差下限</translation>
    </message>
  </context>
  <context>
    <name>widgets</name>
    <message>
      <source># Help

There is no page about “{name}”.</source>
      <translation># 帮助

没有关于“{name}”的页面。</translation>
    </message>
    <message>
      <source>1 message is open</source>
      <translation>1 条消息未处理</translation>
    </message>
    <message>
      <source>A name cannot contain {list}.</source>
      <translation>名称不能包含 {list}。</translation>
    </message>
    <message>
      <source>A name cannot end with a dot.</source>
      <translation>名称不能以句点结尾。</translation>
    </message>
    <message>
      <source>A project belongs to a rig. Choose one on the page Rig first.</source>
      <translation>项目属于一个测量系统。请先在“测量系统”页选择。</translation>
    </message>
    <message>
      <source>A rig as it is found in a workshop: lens errors, glare, run-out, warm-up, a part that is not its drawing</source>
      <translation>车间里常见的测量设备：镜头误差、杂散光、转台跳动、预热漂移，工件与图纸不完全一致</translation>
    </message>
    <message>
      <source>A sample part, or your own closed mesh; its unit is requested unless it is clearly millimetres</source>
      <translation>示例工件，或您自己的封闭网格；除非明显是毫米，否则会询问单位</translation>
    </message>
    <message>
      <source>A tour of the window on a sample project, in seven steps</source>
      <translation>在示例项目上分七步介绍窗口</translation>
    </message>
    <message>
      <source>A well-kept rig in a measuring room: small errors of lenses, axes, board and part</source>
      <translation>测量室中维护良好的设备：镜头、轴、标定板和工件误差很小</translation>
    </message>
    <message>
      <source>A worn rig in a warm hall, with a printed board</source>
      <translation>高温车间中磨损的设备，使用打印的标定板</translation>
    </message>
    <message>
      <source>Add: {field_words}</source>
      <translation>添加：{field_words}</translation>
    </message>
    <message>
      <source>All</source>
      <translation>全部</translation>
    </message>
    <message>
      <source>Apply to the merged cloud; the stitched cloud is kept</source>
      <translation>应用于合并点云；拼接点云保留</translation>
    </message>
    <message>
      <source>Bad</source>
      <translation>较差</translation>
    </message>
    <message>
      <source>Board temperature</source>
      <translation>标定板温度</translation>
    </message>
    <message>
      <source>Browse…</source>
      <translation>浏览…</translation>
    </message>
    <message>
      <source>Capturing</source>
      <translation>正在采集</translation>
    </message>
    <message>
      <source>Certificate of the board</source>
      <translation>标定板证书</translation>
    </message>
    <message>
      <source>Certificate {name}</source>
      <translation>证书 {name}</translation>
    </message>
    <message>
      <source>Certificate {number}</source>
      <translation>证书 {number}</translation>
    </message>
    <message>
      <source>Certificates (*.toml *.csv);;All files (*)</source>
      <translation>证书 (*.toml *.csv);;所有文件 (*)</translation>
    </message>
    <message>
      <source>Certificate…</source>
      <translation>证书…</translation>
    </message>
    <message>
      <source>Certified marks</source>
      <translation>已认证的标记</translation>
    </message>
    <message>
      <source>Change between the light and the dark theme</source>
      <translation>在浅色与深色主题间切换</translation>
    </message>
    <message>
      <source>Checkerboard</source>
      <translation>棋盘格</translation>
    </message>
    <message>
      <source>Checking</source>
      <translation>正在检查</translation>
    </message>
    <message>
      <source>Choose a mesh of the part</source>
      <translation>选择工件网格</translation>
    </message>
    <message>
      <source>Choose one on the page Rig first.</source>
      <translation>请先在“测量系统”页选择。</translation>
    </message>
    <message>
      <source>Choose where the project is made</source>
      <translation>选择创建项目的位置</translation>
    </message>
    <message>
      <source>Chrome on glass or ceramic</source>
      <translation>玻璃或陶瓷镀铬</translation>
    </message>
    <message>
      <source>Circles</source>
      <translation>圆点</translation>
    </message>
    <message>
      <source>Circles in a row</source>
      <translation>排列的圆点</translation>
    </message>
    <message>
      <source>Click a viewpoint to show its images</source>
      <translation>单击视点以显示其图像</translation>
    </message>
    <message>
      <source>Close the settings</source>
      <translation>关闭设置</translation>
    </message>
    <message>
      <source>Close this message, because its cause is gone</source>
      <translation>关闭此消息，因为其原因已消除</translation>
    </message>
    <message>
      <source>Copy</source>
      <translation>复制</translation>
    </message>
    <message>
      <source>Copy all messages as text</source>
      <translation>将所有消息复制为文本</translation>
    </message>
    <message>
      <source>Dark</source>
      <translation>深色</translation>
    </message>
    <message>
      <source>Dictionary</source>
      <translation>字典</translation>
    </message>
    <message>
      <source>Do what helps</source>
      <translation>执行补救措施</translation>
    </message>
    <message>
      <source>End the tour</source>
      <translation>结束导览</translation>
    </message>
    <message>
      <source>Exact</source>
      <translation>精确</translation>
    </message>
    <message>
      <source>Fail</source>
      <translation>不合格</translation>
    </message>
    <message>
      <source>Failed</source>
      <translation>失败</translation>
    </message>
    <message>
      <source>Film on glass, ± 50 ppm</source>
      <translation>玻璃上胶片，± 50 ppm</translation>
    </message>
    <message>
      <source>Flat plate</source>
      <translation>平板</translation>
    </message>
    <message>
      <source>Fold or unfold the properties</source>
      <translation>折叠或展开属性</translation>
    </message>
    <message>
      <source>Folder of your projects</source>
      <translation>您的项目文件夹</translation>
    </message>
    <message>
      <source>Forget sizes</source>
      <translation>忘记尺寸</translation>
    </message>
    <message>
      <source>Forgotten.</source>
      <translation>已忘记。</translation>
    </message>
    <message>
      <source>From</source>
      <translation>方位角</translation>
    </message>
    <message>
      <source>Full</source>
      <translation>全</translation>
    </message>
    <message>
      <source>Give window and panels their first sizes at the next start</source>
      <translation>下次启动时恢复窗口和面板的初始大小</translation>
    </message>
    <message>
      <source>Guide {value:.0f} mm</source>
      <translation>导轨 {value:.0f} mm</translation>
    </message>
    <message>
      <source>Gypsum cross</source>
      <translation>石膏十字</translation>
    </message>
    <message>
      <source>Half</source>
      <translation>半</translation>
    </message>
    <message>
      <source>Help</source>
      <translation>帮助</translation>
    </message>
    <message>
      <source>Help for this page (F1)</source>
      <translation>本页帮助 (F1)</translation>
    </message>
    <message>
      <source>How well the lengths of the board are known: the scale of everything that is measured with this calibration</source>
      <translation>标定板长度的已知程度：用此标定测得的一切的比例</translation>
    </message>
    <message>
      <source>How well the virtual rig and the part are made; uncertainties and verdicts follow from it</source>
      <translation>虚拟设备和工件的制造精度；不确定度和判定由此而来</translation>
    </message>
    <message>
      <source>Ideal</source>
      <translation>理想</translation>
    </message>
    <message>
      <source>In the folder</source>
      <translation>在文件夹中</translation>
    </message>
    <message>
      <source>In which unit are the points?</source>
      <translation>点的单位是什么？</translation>
    </message>
    <message>
      <source>In which unit is the mesh?</source>
      <translation>网格的单位是什么？</translation>
    </message>
    <message>
      <source>In which unit is the nominal?</source>
      <translation>名义模型的单位是什么？</translation>
    </message>
    <message>
      <source>Inner corners across</source>
      <translation>横向内角点</translation>
    </message>
    <message>
      <source>Inner corners down</source>
      <translation>纵向内角点</translation>
    </message>
    <message>
      <source>Inspect a cloud or mesh from a file, against a nominal or by a program</source>
      <translation>按名义模型或程序检测文件中的点云或网格</translation>
    </message>
    <message>
      <source>Keep points</source>
      <translation>保留点</translation>
    </message>
    <message>
      <source>Keep running</source>
      <translation>继续运行</translation>
    </message>
    <message>
      <source>Keep the points inside a box</source>
      <translation>保留盒内的点</translation>
    </message>
    <message>
      <source>Keep the points on one side of a plane</source>
      <translation>保留平面一侧的点</translation>
    </message>
    <message>
      <source>Kept in {file}.</source>
      <translation>保存在 {file}。</translation>
    </message>
    <message>
      <source>Kind of filter</source>
      <translation>过滤器类型</translation>
    </message>
    <message>
      <source>Language</source>
      <translation>语言</translation>
    </message>
    <message>
      <source>Least area of a patch to keep, in mm²</source>
      <translation>要保留的碎片的最小面积，mm²</translation>
    </message>
    <message>
      <source>Least number of other points within the radius</source>
      <translation>半径内其他点的最少数量</translation>
    </message>
    <message>
      <source>Leave the window open</source>
      <translation>保持窗口打开</translation>
    </message>
    <message>
      <source>Lengths</source>
      <translation>长度</translation>
    </message>
    <message>
      <source>Light</source>
      <translation>浅色</translation>
    </message>
    <message>
      <source>Like the system</source>
      <translation>跟随系统</translation>
    </message>
    <message>
      <source>Limit in standard deviations above the mean distance</source>
      <translation>高于平均距离的标准差倍数限值</translation>
    </message>
    <message>
      <source>Loading devices…</source>
      <translation>正在加载设备…</translation>
    </message>
    <message>
      <source>Look here</source>
      <translation>看这里</translation>
    </message>
    <message>
      <source>Lower</source>
      <translation>下</translation>
    </message>
    <message>
      <source>Make nothing</source>
      <translation>不创建</translation>
    </message>
    <message>
      <source>Make the folder of the project</source>
      <translation>创建项目文件夹</translation>
    </message>
    <message>
      <source>Marker</source>
      <translation>标记</translation>
    </message>
    <message>
      <source>Meshes (*.stl *.ply *.obj)</source>
      <translation>网格 (*.stl *.ply *.obj)</translation>
    </message>
    <message>
      <source>Messages shown</source>
      <translation>显示的消息</translation>
    </message>
    <message>
      <source>Moving</source>
      <translation>移动中</translation>
    </message>
    <message>
      <source>New, open, copy or close a project; settings; exit</source>
      <translation>新建、打开、复制或关闭项目；设置；退出</translation>
    </message>
    <message>
      <source>No messages. What happens during a measurement is listed here.</source>
      <translation>没有消息。测量过程中发生的情况将列在此处。</translation>
    </message>
    <message>
      <source>No project open</source>
      <translation>没有打开的项目</translation>
    </message>
    <message>
      <source>No tolerance</source>
      <translation>无公差</translation>
    </message>
    <message>
      <source>No viewpoints yet. Generate a plan, add a viewpoint above, or open the file of a plan.</source>
      <translation>尚无视点。请生成计划、在上方添加视点，或打开计划文件。</translation>
    </message>
    <message>
      <source>Not checked yet</source>
      <translation>尚未检查</translation>
    </message>
    <message>
      <source>Not every system takes this name for a folder. Choose another, such as {name}.</source>
      <translation>并非所有系统都接受此文件夹名称。请选择其他名称，例如 {name}。</translation>
    </message>
    <message>
      <source>Not now</source>
      <translation>以后再说</translation>
    </message>
    <message>
      <source>Not proven</source>
      <translation>未证实</translation>
    </message>
    <message>
      <source>Not stated</source>
      <translation>未说明</translation>
    </message>
    <message>
      <source>Note</source>
      <translation>说明</translation>
    </message>
    <message>
      <source>Nothing but noise and what the program's model describes: what the algorithms reach</source>
      <translation>只有噪声和程序模型所描述的误差：算法本身所能达到的水平</translation>
    </message>
    <message>
      <source>Now</source>
      <translation>现在</translation>
    </message>
    <message>
      <source>Number of neighbours for the mean distance</source>
      <translation>用于平均距离的邻点数</translation>
    </message>
    <message>
      <source>Of the board in °C with its uncertainty (k = 2), while the images are taken; empty: not measured</source>
      <translation>拍摄时标定板的温度，°C，及其不确定度 (k = 2)；留空：未测量</translation>
    </message>
    <message>
      <source>Operator</source>
      <translation>操作员</translation>
    </message>
    <message>
      <source>Own mesh file…</source>
      <translation>自有网格文件…</translation>
    </message>
    <message>
      <source>Pass</source>
      <translation>合格</translation>
    </message>
    <message>
      <source>Patches</source>
      <translation>碎片</translation>
    </message>
    <message>
      <source>Point and mesh files do not contain a unit. All lengths and verdicts depend on it, so it has to be confirmed.</source>
      <translation>点和网格文件不含单位。所有长度和判定都取决于它，因此须确认。</translation>
    </message>
    <message>
      <source>Position of the plane along its axis, in mm</source>
      <translation>平面沿其轴线的位置，mm</translation>
    </message>
    <message>
      <source>Printed, ± 0.1 mm on 180 mm</source>
      <translation>打印，180 mm 上 ± 0.1 mm</translation>
    </message>
    <message>
      <source>Problem</source>
      <translation>问题</translation>
    </message>
    <message>
      <source>Processed</source>
      <translation>已处理</translation>
    </message>
    <message>
      <source>Progress of the job</source>
      <translation>任务进度</translation>
    </message>
    <message>
      <source>Quarter</source>
      <translation>四分之一</translation>
    </message>
    <message>
      <source>Radius in mm</source>
      <translation>半径（mm）</translation>
    </message>
    <message>
      <source>Radius outlier removal, by the number of neighbours</source>
      <translation>按邻点数去除半径离群点</translation>
    </message>
    <message>
      <source>Remove beyond</source>
      <translation>去除超过</translation>
    </message>
    <message>
      <source>Remove isolated patches below</source>
      <translation>去除孤立碎片，小于</translation>
    </message>
    <message>
      <source>Remove small isolated patches</source>
      <translation>去除小的孤立碎片</translation>
    </message>
    <message>
      <source>Remove with fewer than</source>
      <translation>去除邻点少于</translation>
    </message>
    <message>
      <source>Resolution</source>
      <translation>分辨率</translation>
    </message>
    <message>
      <source>Robot x</source>
      <translation>机器人 x</translation>
    </message>
    <message>
      <source>Robot y</source>
      <translation>机器人 y</translation>
    </message>
    <message>
      <source>Robot z</source>
      <translation>机器人 z</translation>
    </message>
    <message>
      <source>Row distance</source>
      <translation>行距</translation>
    </message>
    <message>
      <source>Rows</source>
      <translation>行</translation>
    </message>
    <message>
      <source>Save log, settings and versions in one file; it holds no secrets</source>
      <translation>将日志、设置和版本保存到一个文件；不含秘密</translation>
    </message>
    <message>
      <source>Seed</source>
      <translation>种子</translation>
    </message>
    <message>
      <source>Seen to</source>
      <translation>已看到</translation>
    </message>
    <message>
      <source>Set up operator mode: PIN, folders, shifts</source>
      <translation>设置操作模式：PIN、文件夹、班次</translation>
    </message>
    <message>
      <source>Settings</source>
      <translation>设置</translation>
    </message>
    <message>
      <source>Settling</source>
      <translation>正在稳定</translation>
    </message>
    <message>
      <source>Show all messages</source>
      <translation>显示所有消息</translation>
    </message>
    <message>
      <source>Side of the plane to keep</source>
      <translation>要保留的平面一侧</translation>
    </message>
    <message>
      <source>Side view</source>
      <translation>侧视图</translation>
    </message>
    <message>
      <source>Skipped</source>
      <translation>已跳过</translation>
    </message>
    <message>
      <source>Square</source>
      <translation>方格</translation>
    </message>
    <message>
      <source>Statistical</source>
      <translation>统计</translation>
    </message>
    <message>
      <source>Statistical outlier removal, by the mean distance to neighbours</source>
      <translation>按到邻点的平均距离去除统计离群点</translation>
    </message>
    <message>
      <source>Step in mm or degrees</source>
      <translation>步长（mm 或度）</translation>
    </message>
    <message>
      <source>Still open</source>
      <translation>未处理</translation>
    </message>
    <message>
      <source>Stop all axes, lamps and cameras (Esc). This is no safety function.</source>
      <translation>停止所有轴、灯和相机 (Esc)。这不是安全功能。</translation>
    </message>
    <message>
      <source>Stop and close</source>
      <translation>停止并关闭</translation>
    </message>
    <message>
      <source>Stop at the next safe point</source>
      <translation>在下一个安全点停止</translation>
    </message>
    <message>
      <source>Stop everything that moves, then close the window</source>
      <translation>停止一切运动，然后关闭窗口</translation>
    </message>
    <message>
      <source>Stops when the present step ends; nothing new is begun.</source>
      <translation>当前步骤结束后停止；不再开始新的步骤。</translation>
    </message>
    <message>
      <source>Such as “Housing 4711”</source>
      <translation>例如“壳体 4711”</translation>
    </message>
    <message>
      <source>Table ⌀ {value:.0f} mm</source>
      <translation>转台 ⌀ {value:.0f} mm</translation>
    </message>
    <message>
      <source>Temperature of the board</source>
      <translation>标定板的温度</translation>
    </message>
    <message>
      <source>The seed determines the hidden errors of robot, guide, table and lenses</source>
      <translation>种子决定机器人、导轨、转台和镜头的隐藏误差</translation>
    </message>
    <message>
      <source>Theme</source>
      <translation>主题</translation>
    </message>
    <message>
      <source>This cannot be read. {tip}.</source>
      <translation>无法读取。{tip}。</translation>
    </message>
    <message>
      <source>This is not a number.</source>
      <translation>这不是数字。</translation>
    </message>
    <message>
      <source>Top view</source>
      <translation>顶视图</translation>
    </message>
    <message>
      <source>Turn about x</source>
      <translation>绕 x 旋转</translation>
    </message>
    <message>
      <source>Turn about y</source>
      <translation>绕 y 旋转</translation>
    </message>
    <message>
      <source>Turn about z</source>
      <translation>绕 z 旋转</translation>
    </message>
    <message>
      <source>Unit of lengths</source>
      <translation>长度单位</translation>
    </message>
    <message>
      <source>Upper</source>
      <translation>上</translation>
    </message>
    <message>
      <source>Use this unit</source>
      <translation>使用此单位</translation>
    </message>
    <message>
      <source>Usual</source>
      <translation>一般</translation>
    </message>
    <message>
      <source>Viewpoint</source>
      <translation>视点</translation>
    </message>
    <message>
      <source>Viewpoints</source>
      <translation>视点</translation>
    </message>
    <message>
      <source>Waiting</source>
      <translation>等待中</translation>
    </message>
    <message>
      <source>Warning</source>
      <translation>警告</translation>
    </message>
    <message>
      <source>What happened</source>
      <translation>发生了什么</translation>
    </message>
    <message>
      <source>What to do</source>
      <translation>应对措施</translation>
    </message>
    <message>
      <source>While a button is held, one step follows the other; the motion ends with the step under way when it is released.</source>
      <translation>按住按钮时逐步移动；松开后，运动在当前步结束。</translation>
    </message>
    <message>
      <source>Window</source>
      <translation>窗口</translation>
    </message>
    <message>
      <source>Write one setting per line, as TOML: name = value. Texts are in quotation marks</source>
      <translation>每行写一个设置，TOML 格式：名称 = 值。文本加引号</translation>
    </message>
    <message>
      <source>a {{ color: {colour}; }}</source>
      <translation>a {{ color: {colour}; }}</translation>
    </message>
    <message>
      <source>above x</source>
      <translation>高于 x</translation>
    </message>
    <message>
      <source>above y</source>
      <translation>高于 y</translation>
    </message>
    <message>
      <source>above z</source>
      <translation>高于 z</translation>
    </message>
    <message>
      <source>below x</source>
      <translation>低于 x</translation>
    </message>
    <message>
      <source>below y</source>
      <translation>低于 y</translation>
    </message>
    <message>
      <source>below z</source>
      <translation>低于 z</translation>
    </message>
    <message>
      <source>mm</source>
      <translation>mm</translation>
    </message>
    <message>
      <source>name = value</source>
      <translation>名称 = 值</translation>
    </message>
    <message>
      <source>neighbours</source>
      <translation>邻点</translation>
    </message>
    <message>
      <source>not measured; such as 21.5±0.5</source>
      <translation>未测量；例如 21.5±0.5</translation>
    </message>
    <message>
      <source>others within</source>
      <translation>个其他点，距离不超过</translation>
    </message>
    <message>
      <source>plan's</source>
      <translation>按计划</translation>
    </message>
    <message>
      <source>pose</source>
      <translation>个位姿</translation>
    </message>
    <message>
      <source>poses</source>
      <translation>个位姿</translation>
    </message>
    <message>
      <source>{closed} Show</source>
      <translation>{closed} 显示</translation>
    </message>
    <message>
      <source>{count} angle</source>
      <translation>{count} 个角度</translation>
    </message>
    <message>
      <source>{count} angles</source>
      <translation>{count} 个角度</translation>
    </message>
    <message>
      <source>{count} cannot be scanned. {tip}</source>
      <translation>{count}无法扫描。{tip}</translation>
    </message>
    <message>
      <source>{count} messages are open</source>
      <translation>{count} 条消息未处理</translation>
    </message>
    <message>
      <source>{end} limit of the box along {axis}, in mm</source>
      <translation>盒子沿 {axis} 的{end}限，mm</translation>
    </message>
    <message>
      <source>{finding}: probably {words}.</source>
      <translation>{finding}：可能是{words}。</translation>
    </message>
    <message>
      <source>{name}, in {words}</source>
      <translation>{name}，位于 {words}</translation>
    </message>
    <message>
      <source>{open} Hide</source>
      <translation>{open} 隐藏</translation>
    </message>
    <message>
      <source>{time} left</source>
      <translation>剩余 {time}</translation>
    </message>
    <message>
      <source>{title} is still running. Closing the window stops it; everything stored so far is kept.</source>
      <translation>{title}仍在运行。关闭窗口会停止它；已存内容会保留。</translation>
    </message>
    <message>
      <source>{value} exists already. Choose another name.</source>
      <translation>{value} 已存在。请选择其他名称。</translation>
    </message>
    <message>
      <source>{words}
Click to see all messages.</source>
      <translation>{words}
单击查看所有消息。</translation>
    </message>
    <message>
      <source>{words} – the longest side is {quantity}</source>
      <translation>{words} – 最长边为 {quantity}</translation>
    </message>
    <message>
      <source>{word} (Ctrl+{value})</source>
      <translation>{word} (Ctrl+{value})</translation>
    </message>
    <message>
      <source>σ over</source>
      <translation>σ，相对</translation>
    </message>
  </context>
  <context>
    <name>wizards</name>
    <message>
      <source>, {out} not used</source>
      <translation>，{out} 未使用</translation>
    </message>
    <message>
      <source>A calibration is valid for the temperature at which it was made.</source>
      <translation>标定对其进行时的温度有效。</translation>
    </message>
    <message>
      <source>A new project is made.</source>
      <translation>创建一个新项目。</translation>
    </message>
    <message>
      <source>A run that was stopped is continued.</source>
      <translation>已停止的运行会继续。</translation>
    </message>
    <message>
      <source>A simulated rig with hidden errors. The result page shows the true values beside the estimates.</source>
      <translation>带隐藏误差的模拟测量系统。结果页在估计值旁显示真值。</translation>
    </message>
    <message>
      <source>Accept</source>
      <translation>接受</translation>
    </message>
    <message>
      <source>Accept anyway</source>
      <translation>仍然接受</translation>
    </message>
    <message>
      <source>Back to live</source>
      <translation>回到实时</translation>
    </message>
    <message>
      <source>Back to the views</source>
      <translation>回到视图</translation>
    </message>
    <message>
      <source>Begin</source>
      <translation>开始</translation>
    </message>
    <message>
      <source>Board</source>
      <translation>标定板</translation>
    </message>
    <message>
      <source>Calibrate automatically</source>
      <translation>自动标定</translation>
    </message>
    <message>
      <source>Calibrated and stored in the project.</source>
      <translation>已标定并随项目保存。</translation>
    </message>
    <message>
      <source>Change</source>
      <translation>变化</translation>
    </message>
    <message>
      <source>Check the board</source>
      <translation>检查标定板</translation>
    </message>
    <message>
      <source>Choose a folder</source>
      <translation>选择文件夹</translation>
    </message>
    <message>
      <source>Choose other images</source>
      <translation>选择其他图像</translation>
    </message>
    <message>
      <source>Collect more</source>
      <translation>继续采集</translation>
    </message>
    <message>
      <source>Connect the rig and take the images</source>
      <translation>连接测量系统并拍摄图像</translation>
    </message>
    <message>
      <source>Continue it</source>
      <translation>继续</translation>
    </message>
    <message>
      <source>Corners</source>
      <translation>角点</translation>
    </message>
    <message>
      <source>Cross-validation</source>
      <translation>交叉验证</translation>
    </message>
    <message>
      <source>Detected corners; rejected ones in red</source>
      <translation>检测到的角点；被拒绝的为红色</translation>
    </message>
    <message>
      <source>Each view is predicted by a calibration without it: {quantity}</source>
      <translation>每个视图由不含它的标定预测：{quantity}</translation>
    </message>
    <message>
      <source>Error</source>
      <translation>误差</translation>
    </message>
    <message>
      <source>Evaluating the result…</source>
      <translation>正在评定结果…</translation>
    </message>
    <message>
      <source>Fix the board in the centre of the table, tilted about 45° towards the robot.</source>
      <translation>将标定板固定在转台中心，朝机器人倾斜约 45°。</translation>
    </message>
    <message>
      <source>Folder with images of the board</source>
      <translation>含标定板图像的文件夹</translation>
    </message>
    <message>
      <source>Folder with the images</source>
      <translation>图像文件夹</translation>
    </message>
    <message>
      <source>From the rig</source>
      <translation>来自测量系统</translation>
    </message>
    <message>
      <source>Good views</source>
      <translation>良好视图</translation>
    </message>
    <message>
      <source>Guide positions</source>
      <translation>导轨位置</translation>
    </message>
    <message>
      <source>How it was determined</source>
      <translation>如何确定</translation>
    </message>
    <message>
      <source>It must not move until the run has ended.</source>
      <translation>运行结束前不得移动。</translation>
    </message>
    <message>
      <source>Keep the previous one</source>
      <translation>保留之前的</translation>
    </message>
    <message>
      <source>Let the cameras warm up.</source>
      <translation>请让相机预热。</translation>
    </message>
    <message>
      <source>New folder, or an existing project of this rig</source>
      <translation>新文件夹，或此测量系统的已有项目</translation>
    </message>
    <message>
      <source>No board</source>
      <translation>没有标定板</translation>
    </message>
    <message>
      <source>No board found</source>
      <translation>未找到标定板</translation>
    </message>
    <message>
      <source>No camera detects the board from {names}.</source>
      <translation>没有相机从 {names} 检测到标定板。</translation>
    </message>
    <message>
      <source>No rig is chosen: choose one on the page Rig.</source>
      <translation>未选择测量系统：请在“测量系统”页选择。</translation>
    </message>
    <message>
      <source>Not calibrated. Views taken so far are kept; Start continues.</source>
      <translation>未标定。至今拍摄的视图保留；“开始”会继续。</translation>
    </message>
    <message>
      <source>Not determined: {what}.</source>
      <translation>未确定：{what}。</translation>
    </message>
    <message>
      <source>Not used yet</source>
      <translation>尚未使用</translation>
    </message>
    <message>
      <source>Nothing is missing</source>
      <translation>没有缺少</translation>
    </message>
    <message>
      <source>One line per position of the board, in the order of the images. A folder in which a project keeps its views of the board needs no tables: it holds where the axes stood.</source>
      <translation>每行对应标定板的一个位置，按图像顺序。保存标定板视图的项目文件夹不需要表格：其中记录了各轴的位置。</translation>
    </message>
    <message>
      <source>Previous calibration</source>
      <translation>之前的标定</translation>
    </message>
    <message>
      <source>Redo the change (Ctrl+Y)</source>
      <translation>重做更改 (Ctrl+Y)</translation>
    </message>
    <message>
      <source>Remove the chosen view (Delete)</source>
      <translation>移除所选视图 (Delete)</translation>
    </message>
    <message>
      <source>Removed</source>
      <translation>已移除</translation>
    </message>
    <message>
      <source>Robot poses</source>
      <translation>机器人位姿</translation>
    </message>
    <message>
      <source>See the result</source>
      <translation>查看结果</translation>
    </message>
    <message>
      <source>Seed of the rig</source>
      <translation>测量系统的种子</translation>
    </message>
    <message>
      <source>Set up</source>
      <translation>设置</translation>
    </message>
    <message>
      <source>Show next</source>
      <translation>显示下一个</translation>
    </message>
    <message>
      <source>Show the newest image again</source>
      <translation>再次显示最新图像</translation>
    </message>
    <message>
      <source>Start again takes it again.</source>
      <translation>“重新开始”会重新拍摄。</translation>
    </message>
    <message>
      <source>Std. dev.</source>
      <translation>标准差</translation>
    </message>
    <message>
      <source>Stop after this view; what was collected is kept</source>
      <translation>此视图后停止；已采集的内容保留</translation>
    </message>
    <message>
      <source>Stop everything that moves; views taken so far are kept</source>
      <translation>停止一切运动；至今拍摄的视图保留</translation>
    </message>
    <message>
      <source>Stop this check; the result does not change and can be accepted now</source>
      <translation>停止此检查；结果不变，现在即可接受</translation>
    </message>
    <message>
      <source>Stopped. Views taken so far are kept; Start continues.</source>
      <translation>已停止。至今拍摄的视图保留；“开始”会继续。</translation>
    </message>
    <message>
      <source>Table angles</source>
      <translation>转台角度</translation>
    </message>
    <message>
      <source>Tables (*.csv);;All files (*)</source>
      <translation>表格 (*.csv);;所有文件 (*)</translation>
    </message>
    <message>
      <source>Take one view</source>
      <translation>拍摄一个视图</translation>
    </message>
    <message>
      <source>Take {count}</source>
      <translation>拍摄 {count}</translation>
    </message>
    <message>
      <source>Take {more} more views</source>
      <translation>再拍摄 {more} 个视图</translation>
    </message>
    <message>
      <source>The board of this project.</source>
      <translation>此项目的标定板。</translation>
    </message>
    <message>
      <source>The images appear here as they are taken.</source>
      <translation>拍摄的图像在此显示。</translation>
    </message>
    <message>
      <source>The rig takes about 70 images of one board from all sides. Cameras, hand–eye, linear guide and table axis are then solved together.</source>
      <translation>测量系统从各个方向拍摄约 70 幅同一标定板的图像。随后一并求解相机、手眼、直线导轨和转台轴线。</translation>
    </message>
    <message>
      <source>The robot brings the cameras to the board. Fix the board on the table first, and keep the cell clear.</source>
      <translation>机器人将相机移到标定板处。请先将标定板固定在转台上，并保持工作站畅通。</translation>
    </message>
    <message>
      <source>The wizard shows what is missing while you collect, and saves every view at once.</source>
      <translation>向导在采集时显示缺少的部分，并立即保存每个视图。</translation>
    </message>
    <message>
      <source>There are enough views. More of them improve the result slightly.</source>
      <translation>视图已足够。更多视图会略微改善结果。</translation>
    </message>
    <message>
      <source>These views do not determine a result yet.</source>
      <translation>这些视图尚不能确定结果。</translation>
    </message>
    <message>
      <source>True value</source>
      <translation>真值</translation>
    </message>
    <message>
      <source>True values are known because the rig is simulated. The measurement never reads them.</source>
      <translation>测量系统是模拟的，因此真值已知。测量从不读取真值。</translation>
    </message>
    <message>
      <source>Undo the last change (Ctrl+Z)</source>
      <translation>撤销上一次更改 (Ctrl+Z)</translation>
    </message>
    <message>
      <source>Value</source>
      <translation>值</translation>
    </message>
    <message>
      <source>View {view} rejected: {reason}</source>
      <translation>视图 {view} 被拒绝：{reason}</translation>
    </message>
    <message>
      <source>Views stored in the project are not taken again.</source>
      <translation>存储在项目中的视图不再拍摄。</translation>
    </message>
    <message>
      <source>What is still missing</source>
      <translation>仍缺少的部分</translation>
    </message>
    <message>
      <source>What this wizard does (F1)</source>
      <translation>此向导的作用 (F1)</translation>
    </message>
    <message>
      <source>Where corners were detected so far; the darker, the more often</source>
      <translation>至今检测到角点的位置；越深越频繁</translation>
    </message>
    <message>
      <source>Where the board should appear in the next view</source>
      <translation>下一视图中标定板应出现的位置</translation>
    </message>
    <message>
      <source>With these views</source>
      <translation>使用这些视图</translation>
    </message>
    <message>
      <source>and {value} more</source>
      <translation>以及另外 {value} 项</translation>
    </message>
    <message>
      <source>board images</source>
      <translation>标定板图像</translation>
    </message>
    <message>
      <source>corner</source>
      <translation>个角点</translation>
    </message>
    <message>
      <source>corners</source>
      <translation>个角点</translation>
    </message>
    <message>
      <source>looking for the board</source>
      <translation>正在寻找标定板</translation>
    </message>
    <message>
      <source>name,position_mm</source>
      <translation>name,position_mm</translation>
    </message>
    <message>
      <source>name,x_mm,y_mm,z_mm,qw,qx,qy,qz</source>
      <translation>name,x_mm,y_mm,z_mm,qw,qx,qy,qz</translation>
    </message>
    <message>
      <source>position,angle_deg</source>
      <translation>position,angle_deg</translation>
    </message>
    <message>
      <source>residual {residual}</source>
      <translation>残差 {residual}</translation>
    </message>
    <message>
      <source>shows fringes</source>
      <translation>投射条纹</translation>
    </message>
    <message>
      <source>{caption}
There is no image of this view.</source>
      <translation>{caption}
没有此视图的图像。</translation>
    </message>
    <message>
      <source>{count} in use</source>
      <translation>使用 {count}</translation>
    </message>
    <message>
      <source>{count} of an earlier session are kept{words}.</source>
      <translation>保留了先前会话的 {count}{words}。</translation>
    </message>
    <message>
      <source>{count} taken, {kept} stored before.</source>
      <translation>已拍摄 {count}，此前存储 {kept}。</translation>
    </message>
    <message>
      <source>{rest} more have enough</source>
      <translation>另外 {rest} 项已足够</translation>
    </message>
    <message>
      <source>{value:.1f} standard deviations</source>
      <translation>{value:.1f} 倍标准差</translation>
    </message>
    <message>
      <source>{viewpoint_id} failed: {reason}</source>
      <translation>{viewpoint_id} 失败：{reason}</translation>
    </message>
  </context>
  <context>
    <name>workers</name>
    <message>
      <source>A file</source>
      <translation>文件</translation>
    </message>
    <message>
      <source>Stored data is not affected; try again. If it happens again, send {log} in the folder MeasureApp of your home to support.</source>
      <translation>已存数据不受影响；请重试。若再次发生，请将主目录 MeasureApp 文件夹中的 {log} 发送给支持人员。</translation>
    </message>
    <message>
      <source>{doing} stopped by an internal error ({name}: {error}).</source>
      <translation>{doing}因内部错误停止（{name}：{error}）。</translation>
    </message>
    <message>
      <source>{value} cannot be used: {value_2}.</source>
      <translation>无法使用 {value}：{value_2}。</translation>
    </message>
  </context>
</TS>
