<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
  <context>
    <name>actions</name>
    <message>
      <source>Command</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Commands</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Everywhere</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keys</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing fits. Try other words.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Search for a command</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Shortcuts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This needs the engineer's role.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Type what you want to do</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>small</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>title</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>app</name>
    <message>
      <source>%(asctime)s %(name)s: %(message)s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The last action</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>charts</name>
    <message>
      <source>Grey levels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saturated {saturated}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{counted} points, {ends}</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>clouds</name>
    <message>
      <source> and registration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, at least {least:g}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, at most {most:g}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, filtered {counted}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, saturated</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Accepted by cloud quality</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Analysis failed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Brightness in the images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CSV (*.csv)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {camera}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cancel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cancelled</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cancelled. Nothing was changed; decode to continue.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click a pixel in the picture, or a reason in the list, for an explanation.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cloud</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clouds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clouds after registration to their neighbours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clouds placed by robot, guide and table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clouds shown</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Colour</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Colour by</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Completeness</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Composite</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correction, rotation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Crop and clean the merged cloud; the stitched cloud is kept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Decode</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Decoded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Decoded, brightest</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Determined by kinematics only</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Distance from the merged surface, in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Doubtful</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Each viewpoint gives a point cloud; registration aligns them. The demo creates some in one or two minutes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exclude this view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Excluded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Excluded manually.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Filter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Filtered</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fit the image into the window</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Grey</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Grey level at {words}: {grey}{full}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Grey level, {words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Grey levels of the image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images and holes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images and holes – {viewpoint_id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images and holes: {viewpoint_id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images – {viewpoint_id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images: {viewpoint_id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Kinematic</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Limit of the correction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Longest unsaturated exposure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lost in decoding</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lost in matching</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Manual</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Merged</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Merged cloud after filtering</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Modulation over noise</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move the mouse over the image, or the arrow keys, to read values.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No clouds yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No views yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Noise</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing was changed. Recompute to continue.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One colour per view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Order conflicts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Orientation σ</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Outliers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Overlap</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Phase noise (median)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixels decoded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Position σ</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reasons</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recompute</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Registered</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Registration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rejected points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Removed by cleaning</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Row {line}, column {across}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Run the demo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saturated pixels are red.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save the profile</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saved: {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Share</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show all</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show everything from the front</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show or hide this view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Signal to noise</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard deviation of each point, in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State of the pixels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stored images, phase, modulation, σ and exposures of the selected view, and profiles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The first cloud appears when the first viewpoint is processed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images are decoded; the project is not changed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of the selected view, and why pixels have no point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The pixels can be inspected as soon as this is complete.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The profile was not saved: {error}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The space bar shows or hides the selected view.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The view is recomputed from its stored images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This view has not been analysed yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tracing the point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo the last change of the colour scale</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo the last choice of a view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo the last filter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo the last measured point or distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use this view anyway</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Used by manual choice. </source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Used by manual choice. {why}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Valid pixels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Values along a line, which the mouse or the numbers move</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Weighted mean of all registered clouds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Yes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>accepted by hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>grey level</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>per mm²</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>phase noise</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>point σ</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>projector column</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>refused by hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{counted} points. Pixels with measured surface: {said}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count}, {total} points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{quantity} decoded from all unsaturated exposures, {quantity_2} from the brightest unsaturated one alone (rule of the paper).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{words}, kinematic positions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{words}; merged {counted}</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>controllers</name>
    <message>
      <source> It is stored in the project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, blur {blur_px}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>3-D report (HTML)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add {id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Adding to the series</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All devices are connected and ready.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All images are taken.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Allowing the driver</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Analysing {viewpoint_id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Another task is running: {busy_with}. Save the rig when it has ended.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Another: {words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Being measured again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the rig, then press Recompute on the page Scan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibration of the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Call the engineer.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Changing the nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Checking before the start</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Checking the PIN</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Checking the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Checking the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Checking with views held back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choice undone. Views stitched again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a new folder, or the folder of a project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a rig on the page Rig first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose files of the same part, or other units.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one on the page Rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the nominal of the part to see the predicted coverage.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the nominal of this part, or export it in millimetres.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click another point, or choose another shape.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Comparing the measurements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Comparing the scan with its nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Comparing with the nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connect the rig on the page Rig first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connected, but not ready: {list}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connecting the devices</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connecting the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connecting {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copying the project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Could not be measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Coverage is predicted for up to {most_viewpoints} viewpoints.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Current</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Data stored so far is kept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Decoding {viewpoint_id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Demo: {stem}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detecting the board in {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dimensions still refer to the stitched cloud.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Disconnecting</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Disconnecting the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Distortion</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Documents</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Drawing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Duplicate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Evaluating the result</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Everything as JSON</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Everything was stopped.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exporting {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposures</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Extending the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Filing the result</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Filtering</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Finding the face</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Finding the references</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Generate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Generating a plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Go on with the page Scan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Growing a feature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Guide and table find their references</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inspection program changed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>It is one of {own}; the rig has {rig}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Its images are stored.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest residual</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Last change undone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Last filter undone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Live images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Loading the drivers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Loading the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Make one on the page Plan, or choose a plan file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Making the project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measurement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measuring again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measuring {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Moving by hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New projects start from it: New project from a template.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No PDF viewer is installed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No PIN is set: anyone can leave operator mode.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No image shows the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No project folder is chosen.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No project is open.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No rig is chosen.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No rig is known yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No surface: {reason}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No view of the board shows the fringes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No {shape} found there: {reason}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Noise of a corner (1 σ)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Noise of a mark (1 σ)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominal changed back.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominal changed to {name}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing can be scanned or recomputed here until that has ended. Then open the project again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a calibrated project with a plan, or scan the part first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a project or run the demo first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open patch (STL)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open the project's plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opening project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opening the calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opening the sample project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opening the session</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Opening {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Operator mode again: there was no input for a while.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Order</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ordering the viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>PDF report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preparing the 3-D view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preparing the measurement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preparing the measurement: </source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preparing the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Press Recompute on the page Scan; no new scan is needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Program and results saved.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Program saved as {name}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Program saved.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading clouds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the devices</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the driver</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the files</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the images of {viewpoint_id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the measurements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the part programs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the report header</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the series</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading view {id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recompute the project to create its documents.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recompute the project to create one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recomputing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Releasing the part programs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rendering the pages</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rendering the report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Repeat {number} of {count}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Report header</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reprojection (rms)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reset the stop on the Rig page before anything moves again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Retake it if you need it after all.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Run `python3 installer/bootstrap.py run` to repair the installation.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Run the demo, or open a project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Run the demo, or recompute the project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saved to {words}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saving the program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saving the report header</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saving the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saving the template</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saving {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>See the list on the page Scan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>See the remedy in the table of devices.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set one by the button beside the role.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Solving</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stale: the program has changed since this was measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stitched cloud (PLY)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stitching again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop was pressed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Storing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Storing raw images as the project states</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Storing the PIN</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Storing the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Storing the settings</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Surface mesh (STL)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table of dimensions (CSV)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table of dimensions (XLSX)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Taking images of the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The 3-D view could not be loaded. Install the graphics libraries listed in the help.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The calibration and the disk are being checked.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The calibration is accepted.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The calibration of the last session is in use again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The clouds are computed and stitched.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The code {shown} belongs to no part program. Choose the part by its card, or call the engineer.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The code {shown} fits several part programs: {list}. Choose one by its card.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The code {shown} is not one of part {value}. Nothing was entered.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The coverage is being predicted…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The disk has {value:.1f} GB free, and this part needs {value_2:.1f} GB.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The file manager could not be opened.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The filter removes no points.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images are stored. They are not processed, because the project has no calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of this view are not on disk. Open the project that contains them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The inspection program has edits that are not saved.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The measurement was stopped.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The next scan uses this plan of {count} viewpoints.{where}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The package {name} is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The page Inspect shows the worst dimension first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The part programs in {folder} cannot be read: {value}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The plan is saved as {name}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The position of the rig is not known.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The project is saved to {folder}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The project was recomputed from the stored images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The report is saved to {path}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The report of repeats is saved as {name}, with a table (CSV) and JSON beside it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The report of the series is saved as {name}, with a table (CSV) and JSON beside it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The result is filed; its report could not be copied to {target}: {error}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The result is saved, but the rig keeps its own cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig is being loaded.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig is calibrated.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig is calibrated. {sentence}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig was saved to {path}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig was stopped: {stopped} {call}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scan continues with the next one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scan continues.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scan failed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scan pauses before its first viewpoint; what comes before it can only be cancelled.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scan started.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The stored results are those of the program before.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The template is saved to {path}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The {subject} is complete.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no PDF report yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no measurement to repeat.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no measurement yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no scan plan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This document does not exist yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This measurement has no surface mesh.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This project's: {words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Times of the moves</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undoing the filter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Unpacking the sample project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Up to {most_ordered} can be.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use stricter limits, or another filter.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoint {viewpoint_id} failed: {reason}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoint {viewpoint_id} has no cloud: {reason}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoint {viewpoint_id} is taken again: {reason}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoint {viewpoint_id} was skipped.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoint {viewpoint_id}: exposures</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoint {viewpoint_id}: {reason}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Views stitched again. The choice is saved with the project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Views used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait until it is loaded, or use recorded images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What was measured so far is kept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Writing the report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Writing the report of repeats</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Writing the report of the series</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wrong PIN.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wrong part: the code is of part {part}, this program measures part {part_number}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Your own: {name}, version {version}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a layout (Typst)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>earlier images kept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>job: {title}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no reason stated</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>not measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>not proven</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>statistics of the deviations</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>stop the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>thing prevents</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>things prevent</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>viewpoint measures</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>viewpoints measure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>without serial number</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>wrong part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{counted} of {before} points removed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} the scan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} viewpoints are too many to be ordered.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} {planned_share} of the surface, {planned_of_allowed} of what the rig can.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{decodable_share} of the lit pixels decodable, {planned_share} as planned</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{folder} cannot be written to: {value}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{folder} holds no calibration of cameras or a rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} added to the inspection program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} has no calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} is open read-only: it is in use by {holder}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} is open.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} is open: {count} viewpoints.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} removed from the inspection program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} saved to {parent}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} was inspected against {name_2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name}, version {version}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{title} is still running.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where} of {times} ms chosen by a probe: {shares}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{words} Not saved with the project: {message}</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.acquire</name>
    <message>
      <source>Black and white by turns</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} is saturated even at {v2} µs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images of the board from {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name a viewpoint of the plan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No viewpoint is left to be skipped.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Point the cameras at a stationary surface (--plan), and check the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reduce the light, or close the aperture.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set sequence = "software" in [head] of the rig description.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Skip a viewpoint that is still to be taken.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start it again to take further viewpoints.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start the run again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The control of a run cannot be used for another one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The image of camera {v1} is dark at {v2} µs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig {v1} is in use by another task.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The run has ended.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The run has no viewpoint {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The run has not started yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoint {v1} cannot be skipped: it is {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoint {v1} is being taken.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait until it is stored.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait until it moves.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait until that has finished, or stop it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>exposure {v1} ms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>noise of camera {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>probe: image {v1} at {v2} ms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot trigger cameras, as the hardware sequence of {v2} needs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: image {v2} at {v3} ms</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.axis_modbus</name>
    <message>
      <source>Check its emergency stop, its supply and its interlocks.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check port or address, cable and power, and that no other program uses it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check station number, port and drive map.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the map fits this drive, and the state of the drive.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the map of the drive.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct this field; the README describes the form.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name one of {v1}, or the path of a map (.toml).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no drive map {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>[links]: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} (station {v2} at {v3}) {v4} (Modbus exception {v5}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} answered {v2} instead of {v3} registers ({v4}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be opened.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be read as a drive map: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not switch its servo on.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: register {v2} reads {v3}, which is not a {v4}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.calibrate</name>
    <message>
      <source>A camera is called {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A folder with images such as left01.png, right01.png: images with the same number show the same position of the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A folder with one folder per position of the board, each with its fringe images of both directions and a MANIFEST.toml.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A {v1} is symmetric under half a turn, so {v2} cannot use it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>According to its angles the table turned by {v1}°, but the board turned by {v2}°.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add observations from other distances, tilts and positions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add observations that show it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add poses turned about a second axis, best at right angles to it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add poses turned about different axes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add poses turned by 20° to 90° about different axes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add poses with larger rotations and translations.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add sharp views with the board tilted in different directions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add views in which both it and another camera see the whole board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add views with the board tilted in different directions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All motions turn about nearly the same axis of the flange ({v1}; {v2}° from parallel): the camera's position along that axis is not observable.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Bring the board to the borders of the projector's image, not only of the camera images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate hand-eye first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate hand–eye</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate it: `measureapp calibrate projector`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the cameras first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the cameras with 4, 5 or 8 coefficients.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the linear guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the projector</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the table axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the whole rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the whole rig first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has no images yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has no view of the board in common with the other cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has {v2} usable views of the board; at least {v3} are needed.{v4}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has {v2} views left that fit the others; at least {v3} are needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} is not calibrated.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cameras, hand–eye, linear guide and table axis in one automatic run</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that guide positions and poses are in mm, in the same order, and that the board did not move.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that robot and board poses are in the same order, and that the rotations are unit quaternions, not degrees.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the board is fixed on the table, and that tables and images are in the same order.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the images show the same rigid board, sharp and in the same order for all cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the order of the positions, the unit (degrees) of the angles, and that the board did not move on the table.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the size of the board: its squares seem to be {v1} times as large as stated.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the unit (degrees) and the order of the table angles, and that the board did not move on the table.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose 4, 5 or 8.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one of: </source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the calibration of these cameras as they are set now, or calibrate them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compare axes in the same frame.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compare calibrations of the same cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cover the images to their borders and corners: lens distortion is largest there.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Coverage of the image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Determines direction and scale of the guide, with cameras and hand–eye as calibrated. Fix the board on the table; the guide moves the robot past it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Determines lens and pose of every camera from images of a board seen from many sides. Fill the images to their borders, and tilt the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Determines lens and pose of the projector from fringes of both directions on the board, with the cameras as calibrated. The phases around a corner of the board identify the projector pixel that lights it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Determines the pose of the head on the flange, with the cameras as calibrated. Fix the board on the table; the robot turns the head.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Determines the table's axis, with cameras and robot as calibrated. Fix the board on the table; the table turns it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Direction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Direction and scale of the guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Every camera needs a name of its own.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fix the board on the table so that it cannot slip.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fix the board on the table. The rig views it from all sides, moves along the guide and turns the table, and everything is solved together.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flange and camera turn by different angles (median difference {v1}°).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Focal length x</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Focal length y</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Focal length, image centre, distortion and pose of every camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give at least 3, better 10 or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give at least {v1} positions of at least 3 corners.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give at least {v1} positions over {v2} mm or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give at least {v1} with different robot poses, and turn the table by 60° or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give at least {v1}, with different poses of the robot, slide positions and table angles.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give columns and rows of the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give guide positions in mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give images of calibrated cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one angle per position.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one image per camera with every observation.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one of each per position.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give poses the robot can reach and from which the board is visible.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the camera Jacobian of every board pose, or no camera prior.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the camera another name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the distance at which parts are measured.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the images of all cameras in the same order, one of each camera per board position.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hand–eye, guide and table axis were determined with the earlier cameras: calibrate the rig next.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hold the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image centre x</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image centre y</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep the robot still while the guide moves: the errors of its poses would count as errors of the guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lens and pose of the projector, relative to calibrated cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>More observations alone will not make it good: sharper images, a larger board, or larger differences between positions are needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>More views for the projector alone will not make it good: {added} of it come from the calibration of the cameras. Calibrate the cameras from more views first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move the guide as far as the board stays in view: a longer travel determines its direction better.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move the guide further</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name a result of the same kind of calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name one of the cameras given.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name the cameras once each, the reference first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Neither the board nor the robot's arm moves; only the guide does.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No camera saw the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No pose of the robot is further than {v1} mm from its base.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing may move while the fringes of one view are taken. White should be bright, but not clipped.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Observations changed since it was solved: solve again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only {v1} of the {v2} marks of the {v3} can be seen.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only {v1} points of the working volume {v2} mm in front of the cameras are seen by two of them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pose of the head on the robot's flange</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Position and direction of the rotary table's axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Position {v1} turned by {v2}° against the first, but its angle says {v3}°.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recorded fringes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recorded images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Roll the camera about its line of sight: it was rolled by only</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rotation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scale</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set the board up steeply on the table, so that its corners lie at different heights, and turn the table further.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show it nearer and farther, sharp, evenly lit and not so bright that its white is clipped.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show more of the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the fixed board from the first robot pose</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the whole board, evenly lit.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Solve again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Solve what was collected first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Spread of distances</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start without calibrated cameras; compare with them later.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sweep of the table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table positions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take a board with {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take a sharper image, or move closer so that the squares appear larger.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take poses</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take ten poses or more: the robot's own errors average out.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take ten views or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take the board at</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take the board from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take the views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The board lies behind the camera: the board poses seem to be board_from_camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The board moved {v1} times as far as the robot.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The board must not move between the views.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The board poses put the board {v1} mm from the camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The board turned by only {v1}° in all.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The cameras are what is to be calibrated.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The centres of the corners' arcs do not form a line (they spread {v1} times as far along the axis as across it; {v2} are needed).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The contribution of robot and hand–eye does not shrink with more observations. Calibrate the whole rig, which averages over many robot poses, or let registration correct it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The corners of the board cannot be refined.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The derivatives of the board poses with respect to the cameras are missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The given cameras have {v1} distortion coefficients, at most {v2} are offered.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The guide travelled {v1} mm, but the board moved 1000 times as far.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of camera {v1} are {v2} × {v3} px, it was calibrated for {v4} × {v5} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of cameras {v1} and {v2} do not belong together: in {v3} of {v4} views they show different board positions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The marks of the board that are visible are too few, or lie on one line.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The motions do not determine the rotation.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The observations do not determine the rig: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The observations leave a parameter undetermined.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The observations of the solution are no longer there.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The pose of the board in observation {v1} is not known.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The poses do not determine the hand-eye transform.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The poses do not determine the rotation.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The positions of a corner lie on a line, not on an arc.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The previous axis is given in frame {v1}, the new one in {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The previous calibration is not one of {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The previous calibration is one of {v1} with {v2} as reference, the new one of {v3} with {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The projector is not calibrated.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The projector was calibrated with the earlier cameras: calibrate it again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The reference camera {v1} has no images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rest of the rig is not calibrated yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The robot moved {v1} mm per displayed millimetre of the guide.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The robot poses seem to be flange_from_base (or the board poses board_from_camera).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The robot poses seem to be in metres: give mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The size of the projector's image is not known.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The translations of the {v1} poses are about {v2} times too small for those of the others.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The uncertainty of the cameras themselves is not known: it comes in addition.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The views of camera {v1} do not determine its focal length ({v2} ± {v3} px).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The views of camera {v1} do not determine its lens.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The {v1} poses seem to be in metres: give mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The {v1} was not detected yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are no candidate poses.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are: </source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no solution yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>They seem to be in metres: give mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tilt it by 20° to 45° to all four sides, and show it nearer and farther.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tilt the board by 20° to 45° in several directions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tilt the board by 20° to 45° to all four sides: this separates the focal length from the distance.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tilt the board in several directions and fill the image.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tilt the board in several directions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tilt, all directions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>To calibrate the linear guide, the hand-eye transform is needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>To calibrate {v1}, calibrated cameras are needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Travel of the guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turn the head about all three axes: up and down, sideways, and about its line of sight.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turn the table as far as the board stays in view: short arcs leave their centre uncertain.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turn the table further</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turn the table further between the positions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turn the table further, best by 60° or more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turns about the line of sight</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turns left and right</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turns up and down</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use the calibration of the cameras that took the images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>View the board from higher up and from lower down: the camera was tilted up and down by only</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>View the board more from the left and from the right: the camera was swung sideways by only</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whole rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>axis direction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>axis point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>axis, across</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>camera on the flange, place</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>camera on the flange, rotation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>camera {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>guide direction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>guide scale</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>in the lower left corner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>in the lower part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>in the lower right corner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>in the middle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>in the upper left corner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>in the upper part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>in the upper right corner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>iteration {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>joint solution of the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>maximum likelihood</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>of a measurement uncertainty of 0.05 mm, 0.02 mm is hardly noticeable and 0.05 mm is all of it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>on the left side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>on the right side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>once more</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>one more view with</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>points from the projector complement those of two cameras and should be as certain</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>points of the volume relative to each other (rms)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>projector's image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>registration of overlapping views corrects 0.1 mm with ease, and starts safely up to 0.5 mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>several cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>straight line of the guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>straight line through the positions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the hand-eye transform</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the linear guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the projector</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the rotation axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>to the left</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>to the right</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>views of one part relative to each other (rms)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>views that are off by less than 0.05 mm need no registration, those up to 0.2 mm register safely</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} angles do not belong to {v2} table positions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} distortion coefficients are not offered.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} {v3} of the board; at least {v4} are needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a kind of calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} observations of the board over {v2}° of the table do not determine the rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} poses do not determine the hand-eye transform.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} robot poses do not belong to {v2} board poses.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} slide positions over {v2} mm do not determine the guide.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} table positions with {v2} corners do not determine the axis.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} views are too few to hold some back.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} views of the board do not check a calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} {v2} could not be used; {v3}: {v4}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.calibration_session</name>
    <message>
      <source>Add observations first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>An image ({v1}) cannot be encoded.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>An observation needs an image.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the permissions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a new folder, or continue the session that is there.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a table with one line per position of the board, or the folder in which a project keeps its views of the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fringes calibrate a projector only.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give fringes instead.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give fringes of one projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give images of one camera at one resolution.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give it with every observation.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one image per camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one line per board position.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give plain images of the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>It was recorded with an earlier version: record the position again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Observation {v1} was removed before.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only what was undone, and nothing changed since, can be redone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record vertical and horizontal fringes at every position: `measureapp patterns export` writes such a set.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore it from a backup, or start again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore it from a backup.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start one by naming the kind, the board and images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take it again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The fringes of observation {v1} were not kept, so the projector's marks cannot be read again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The fringes of {v1} run over {v2} × {v3} px of the projector, those before over {v4} × {v5} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The image of camera {v1} is {v2} × {v3} px; {v4} × {v5} px are expected.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The image {v1} of session {v2}, from which the calibration was made, {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images have no read-back of: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The name {v1} is not in both {v2} and {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no camera {v1} here.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no observation {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is nothing to redo.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is nothing to undo.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo restores it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use the same names.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>board in {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>detecting the board in {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>fringes of {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be read: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be removed: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be used: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has changed since it was saved: its checksum differs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} fringes only; the projector needs those of both directions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} lines for {v3} board positions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} holds no calibration session.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} holds no calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} holds no calibration: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is calibrated from fringes on the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not JSON: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not an empty folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is taken again. {v2}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} of {v2} viewpoints failed: {v3}</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.camera_basler</name>
    <message>
      <source>All {v1} images of the sequence of camera {v2} are triggered.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Arm it first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Arm it for more images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} ({v2}) cannot be opened: {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} ({v2}) is controlled by another program; it was tried for {v3} s.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} did not answer within {v2} s of connecting.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} does not accept triggers after {v2} s.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} does not accept {v2} {v3} at {v4} {v5}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} failed: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} got an image of another camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has no setting {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has no {v2} {v3} (it has: {v4}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has {v2} pixels of {v3}, fewer than the {v4} of the rig description.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} is not armed for triggers by the program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} is not armed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} reads back {v2} = {v3} after {v4} was set: it ignored or limited the value.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} refused {v2} = {v3}: {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check its power and its cable.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check its trigger settings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check power and cables, and that network card and cameras have addresses in one subnet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a value that the camera supports, and close other programs that may set it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose multiples of its step (often 2 or 16).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close the other program (pylon Viewer, another MeasureApp, also on another computer), then connect again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the serial number in the rig description, or check power, cable and IP address: camera and network card need one subnet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct width_px and height_px in the rig description, or offset_px in the settings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restart the program.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.camera_folder</name>
    <message>
      <source>Copy them, or correct the manifest.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct bit_depth in the rig description, or convert the images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct exposure_in_name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the setting files, or the folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the setting folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the setting manifest, or the file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the size in the rig description, or choose images of this camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give every exposure.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} has {v2} × {v3} px, and camera {v4} {v5} × {v6} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} has {v2}, which does not fit the {v3} bit of camera {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rename it, or correct exposure_in_name or files.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set at_end = "loop" to begin again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Some images of {v1} have an exposure and some have none.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The exposure in the name of {v1} is not a number.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The folder {v1} has no file {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The folder {v1} of recorded images does not exist.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The manifest {v1} cannot be read: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The manifest {v1} is not valid TOML: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The manifest {v1}: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The name of {v1} has no exposure by the pattern {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The recording of camera {v1} in {v2} has ended after {v3} images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} images of {v2} are missing, the first is {v3}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.camera_genicam</name>
    <message>
      <source>Camera {v1} has no feature {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has no pixel format for {v2} bit (setting: {v3}; the camera has {v4}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} is not armed for software triggers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1}: no camera with serial number {v2} was found (found: {v3}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1}: packets have {v2} bytes and a delay of {v3} µs, instead of {v4} bytes and {v5} µs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1}: {v2} cannot be {v3} (possible: {v4}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1}: {v2} is {v3} after {v4} was written.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1}: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the setting named, and what this camera supports.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a packet size and a delay that the camera supports.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a value that the camera keeps.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close that program. If it crashed, wait a few seconds, then connect again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct bit_depth in the rig description, or pixel_format in the camera's settings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the serial number in the rig description, or check power, cable and the network address of the camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Update its firmware, or use another driver.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} controls camera {v2} ({v3}).</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.campaign</name>
    <message>
      <source>Check the permissions and the disk.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the shared storage, then start the job again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dask distributed is not installed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a campaign file in TOML.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give folders that contain a project.json, relative to the file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Install the same one everywhere.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Install the same version everywhere.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No cluster answers at {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Process it without --cluster.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Read its log, and start it again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Read the logs of the workers, then start the job again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start fewer workers on it, or give them more: dask worker --memory-limit.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start it with `dask scheduler` and `dask worker ADDRESS`, or use `--cluster local`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start some with: dask worker {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start the job again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The cloud {v1} cannot be read: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The cloud {v1} is damaged.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The cluster at {v1} has no worker.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The cluster gave it up: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The folder {v1} cannot be seen by {v2} of the workers, such as {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The worker {v1} does not answer: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The worker {v1} does not have this program: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The worker {v1} has another version of the program: {v2}; this is {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The worker {v1} may use {v2} GiB of memory, and a task needs about {v3} GiB.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use a storage that all computers mount under the same path.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be written to: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a text.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not valid TOML: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} names no job.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} of {v2} jobs, {v3} of {v4} tasks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: no project lies at {v2}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.compiled</name>
    <message>
      <source>The environment variable {v1} is {v2}, but must be {v3} or {v4}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.data</name>
    <message>
      <source>Give robot pose, guide position and table angle.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The read-back of an axis is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The reference camera {v1} is not among the calibrated cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rotation axis is given in frame {v1}, not in the guide frame.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Transform it to the guide frame.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.devices</name>
    <message>
      <source>A travel of {v1} {v2} is too small for a reading uncertainty of {v3} {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add a table [links.{v1}] to the rig description.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All flips are to the same level.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Black and white of the projector differ by {v1} grey levels, and images of the same one scatter by {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} ends the exposure of its rows one after the other (global reset), and {v2} stays lit meanwhile: the last row would get {v3} ms more light.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} exposes its rows one after the other over {v2} ms, and {v3} is lit during the exposure of {v4} ms only: no instant of light is common to all rows.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} set {v2} µs instead of the requested {v3} µs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the axis moved; command a longer step.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the device is on and connected; if it is, report the error to the author of the driver.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check unit and decimal point. If the travel is right, set counts_per_unit = {v1} and repeat the step.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose an exposure that the camera supports, and switch its automatic exposure off.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Command a step that can be seen, and enter its travel; check that the axis moved.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct it in the rig description.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Disconnect the rig there first. Projects can be opened, processed and reported here meanwhile, without the rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter a number.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fewer than two images were taken between two flips.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flip between black and white.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give drivers of different kinds links of their own.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one level for each time.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hold every level longer, or take images more often.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Link {v1} is a {v2}, and a driver needs a {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No serial adapter with {v1} was found (adapters here: {v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plug it in, or set port, host or usb_serial in [links].</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Point the camera at what the projector lights, and shut out ambient light that flickers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Process its project with `measureapp process PROJECT`, or name the description of a connected rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove the cause, check that nothing is in the way, then reset the stop.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig {v1} is a recording: it has no devices that could be connected, moved or triggered.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig {v1} is in use: {v2} has connected {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig {v1}: the driver {v2} of {v3} failed: {v4}: {v5}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig {v1}: {v2}: {v3} (driver {v4}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scale in use and reading uncertainty must be positive.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set port in [links] instead of usb_serial.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set the camera to global reset, or the projector to hold each pattern for the whole period.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set the camera to rolling shutter, or use a projector that is dark after the exposure.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State the direction by the sign of the travel.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The axis was commanded to move {v1} {v2} and a travel of {v3} {v4} was entered: {v5} by a factor of {v6}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig has no link {v1} (described: {v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig was stopped: {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The times of flips or images are not ascending.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The {v1} is zero.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The {v1} is {v2}, which is no number.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are {v1} times and {v2} levels of flips, {v3} times and {v4} grey levels of images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use a monotonic clock, the same for both.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} flips are too few to find the largest latency.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} of {v2} flips did not settle before the next one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} serial ports have the USB serial number {v2} (adapters here: {v3}).</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.fringe</name>
    <message>
      <source>A + B = {v1} exceeds the saturation of {v2} grey levels.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A contrast of A = {v1}, B = {v2} grey levels cannot be.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A single pitch of {v1} px repeats over the {v2} {v3} of the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add Gray planes, the most significant first, or a coarser pitch.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add a phase-shift group of at least three images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add a second pitch or a Gray code that numbers the periods.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add all images of one exposure together, 8 or 16 bits without sign.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add every exposure of every camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the exposures from long to short, each once.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Allow at least {v1} s.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Allow longer exposures, open the apertures, or use more steps.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Allow more time, or a finer multiple.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Brightness level {v1}{v2} has a single image.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} changed size or bit depth between exposures.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} gave exposure {v2}, but {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} gave {v2} images of shape {v3}; one exposure has {v4} images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has images of shape {v2}; the set needs {v3} exposures of {v4} images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has {v2} images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change the sign of `shift_sign`, or reverse the order of the shifted images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check shift_sign, the order of the images, the pitches and projector_px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that no image was lost or taken without the pattern; record this group again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the camera took every exposure, without automatic gain.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the projector stepped on; record again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the projector stepped on; record this group again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the projector's lamp, the cameras' triggers and links, and ambient light.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose pitches closer to each other, add a third pitch or a Gray code.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose pitches whose longest beat is at least {v1} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Estimate it from a grey ramp, or from six or more steps of one pitch.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Estimate the projector's response with this pattern set.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Expose longer, or turn the ambient light off.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Expose shorter.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposures of camera {v1} are missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give 0 &lt; B ≤ A.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give 1 for the longest and fractions of it for the others.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a contrast that the camera can see.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give dark images too (lens covered), or switch the black level off.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give each of at least five levels once.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} of camera {v2} at {v3} µs contradicts the other exposures in {v4} of its pixels (it is {v5} times as bright as they predict).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No camera sees fringes at {v1} µs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No exposure up to {v1} µs makes a pixel decodable.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No multiple of {v1} µs fits into the budget.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing needs correcting; or record twelve steps of one pitch to see smaller errors.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only {v1} pixels show fringes that are neither saturated nor dark; {v2} are needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pattern set {v1} has no sinusoids.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pattern set {v1} has {v2} Gray codes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Probe with a longer exposure, open the apertures, or check the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Probe with a phase-shift group.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Probe with {v1} µs, or dim the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Put all Gray planes into one group.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record a bright, matt surface that fills the image.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record a viewpoint in one go.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record all cameras with one bit depth and give its saturation.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record all cameras with one bit depth.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record at least three steps of every pitch.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record every pattern at every exposure.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record every pattern once; check that no file was copied over another.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record six or more steps; twelve are good.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove exposures from the bracket.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove pitches: three are enough for any projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the ramp from black to white.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sort the exposures of the stack.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take at least two images of every brightness.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take flat images and use `measureapp noise`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The beat of the pitches {v1} px is {v2} px, shorter than the {v3} {v4} of the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The cameras have images of different bit depths ({v1}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The exposures are not in order from long to short.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The exposures {v1} are not relative to the longest.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The fringe images of camera {v1} do not show its noise: no group of four steps or more with enough light and without harmonics of the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The grey ramp covers the levels {v1}…{v2} of 0…255.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The grey ramp ends in equal levels: the camera or the projector saturates.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The grey ramp has {v1} different levels among {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The grey ramp rises by {v1} grey levels only.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The harmonics of the projector are too strong for {v1} steps: equal phases come from different places.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of brightness level {v1}{v2} differ by {v3} in brightness.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of camera {v1} at {v2} µs are {v3} times as bright as those at {v4} µs, not {v5} times.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The phase correction is for {v1} pitches, pattern set {v2} has {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The phase decreases where the Gray code increases.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The phases of camera {v1} show no error of the projector beyond the unevenness of the scene.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The probe has no sinusoids.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The projector is {v1} px {v2}, the pattern set covers {v3} {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The range of {v1} is {v2} px for {v3} px of the projector: {v4} px of guard band, so that noise turns one edge into the other.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The response of {v1} has no curve, so patterns cannot be corrected beforehand.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The steps of the group are out of order: {v1} and {v2} appear to be exchanged.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The two exposures appear to be exchanged: check their order.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The variance of {v1} does not grow with its brightness.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The variance of {v1} would vanish at grey level {v2}: it has a black level.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use 8- or 16-bit images without sign.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use a pattern set made for this projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use a steady lamp (exposures of whole mains periods) and group images of one exposure.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use more steps, or patterns corrected beforehand.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use raw images: without gamma, denoising, automatic gain or lossy compression.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>decoding {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} Gray planes number {v2} periods of {v3} px: {v4} of {v5} {v6}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} are saturated, black, or too small everywhere.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not fit the other steps of its group.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} exposures are more than {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} give {v2} usable brightness levels from {v3} to {v4} grey levels: gain and read noise cannot be separated.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has grey levels up to {v2}, but the stack saturates at {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is the same as {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is {v2} everywhere than the others of its group: it shows no fringes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is {v2} everywhere where a coarser Gray code plane has stripes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} of the lit pixels are saturated even at {v2} µs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} of the phases of camera {v2} lie beyond the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} pitches are more than {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} s do not suffice for one exposure of {v2} images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} shifted images do not determine mean, modulation and phase.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} shifted images do not separate harmonics from noise.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} shows the same Gray code plane as {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} shows the same pattern as {v2}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.geometry</name>
    <message>
      <source>Correct the numbers after joint 6.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the numbers of this joint.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Joint {v1} of {v2} has {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move it by joint angles.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Narrow the limits to the turns in use: at most {v1} equivalent positions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The flange of {v1} has no rigid transform.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The joint limits of {v1} allow {v2} equivalent positions, whole turns apart, for one pose.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no spherical wrist, so its poses have no configuration data.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.inspection</name>
    <message>
      <source>A local best fit cannot use {v1}: its points are not cut around a nominal.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A spread needs at least two measurements.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add one to the program (nominal = "…"), or set alignment = "none".</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change the entry it names first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that this is the nominal of the part, or crop the surroundings from the cloud.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose another alignment first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose another alignment.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose another shape, or another seed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose measured features.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one of its entries.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose other features, or another alignment.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the nominal of this part, or crop the surroundings from the cloud.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click another place.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compare a cloud that has points.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Datum {v1} constrains nothing beyond {v2}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter another name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter at least one character.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export the cloud again without invalid points.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export the nominal again as STL, PLY or OBJ with triangles.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Feature {v1} has no direction.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the lower limit first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inspect it with a program that has dimensions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Limit it by x_mm, y_mm or z_mm of its cut, or define a nominal.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Limit it by x_mm, y_mm or z_mm of its cut.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure it as a plane, cylinder or cone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move it further inside the surface.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move the section, or widen its strip.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name each measurement once; a spread needs independent scans.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name two or more projects of the same part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No shape grows from this place.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing was measured along the section {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only {v1} of the points lie within {v2} mm of the nominal, in any orientation.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only {v1} points lie in the features and regions of the local best fit, {v2} are needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only {v1} points were measured within {v2} mm of this place, {v3} are needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove these as well, or give them other features first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rename it, so that references follow.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan the part first, or check the file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan these features, or choose others.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan this feature, or align by features that were measured.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Some measured points are not finite numbers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The alignment of the program uses {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The alignment {v1} failed: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The change is not possible: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The datums {v1} do not fix the {v2} of {v3}: free are {v4}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The inspection program has no {v1} {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The name of {v1} is not one of its values.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The nominal extends from {v1} to {v2} mm: place the section inside.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The nominal mesh has no surface.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The nominal of {v1} differs between {v2}: {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The points span {v1} mm, the nominal {v2} mm: they are not of the same part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The program has a {v1} {v2} already.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The program {v1} aligns by best fit, but there is no nominal mesh.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The section {v1} intersects neither the nominal nor measured points.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The tolerance from {v1} to {v2} mm is empty.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are no deviations.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are no distances from a {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are no measured points to inspect.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no alignment.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use a plane, sphere, cylinder or cone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>aligning the points to the nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>distances from the nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>inspection complete</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>its region did not converge</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>its seed lies on an edge, or the surface there is not a {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no measured surface lies within {v1} mm of its seed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>only {v1} points around its seed form one surface, {v2} are needed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>only {v1} points of one {v2} are connected to its seed, {v3} are needed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>only {v1} points were measured around its seed, {v2} are needed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the nominal of a {v1} does not follow from features</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the region grown from its seed covers the whole part ({v1} of {v2} points)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the region grown from its seed is not a {v1}, or too small to determine one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the surface at its seed is not a {v1}: it bends away by {v2} mm over the region</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} and {v2} are blades of different sections: their pitch is undefined</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} and {v2} are the same measurement: all values agree to the last digit.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} and {v2} are {v3}° from parallel (limit {v4}°): their distance is undefined</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} and {v2} do not face opposite directions ({v3}° off): their thickness is undefined</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} and {v2} do not fix {v3}, and the surface point {v4} fixes a translation only. Use an axis or plane as the line, or reference points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} and {v2} face opposite directions: measure a distance, not a step</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} do not have the same dimensions: only one has {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no dimensions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no nominal position</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a constructed feature without a length for its {v2}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a constructed feature without a measured surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a constructed line without a measured surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a plane: its straightness needs `along`, the direction of the lines</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a surface point: a datum must be a plane, an axis or a centre</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2} and has no cone angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2} and has no direction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2} and has no radius</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2} and has no slot {v3}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}, which cannot be a datum for {v3}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: 3-2-1 needs {v3} there</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: a material condition of a datum requires a measured cylinder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: a material condition requires a measured cylinder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: a step is defined between planes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: as a reference point it needs `along` or `lock`, its constrained directions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: it has no nominal surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: position is defined for {v3}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: run-out requires a measured cylinder or plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: run-out requires an axis as its datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: {v3} is defined for a {v4}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: {v3} is defined for planes and axes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a {v2}: {v3} is defined for {v4}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is inclined by {v2}° to {v3}: their distance is undefined</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is used by {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is {v2}° from the axis of {v3}: its run-out is undefined</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is {v2}° from {v3} to {v4}: check the feature and its datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} needs a name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} was not measured at its section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} were inspected with different programs: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: `along` is perpendicular to the plane, which has no lines in that direction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a blade profile needs a nominal mesh, and the program has none</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a mid-plane needs two planes, {v2} and {v3} are not</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a pitch needs at least two measured blades of one section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a point on an axis needs an axis, and the plane from which its distance counts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a projection needs a point or axis, and the plane it is projected onto</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: an average blade needs at least two measured blades of this section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: an intersection needs a plane, and a plane or an axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: an intersection of three needs planes, {v2} is a {v3}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: an offset needs a plane, {v2} is a {v3}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: its axis has only {v2} complete sections, {v3} are needed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: its points are on one line and determine no circle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: its points are on one line and determine no plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: its points coincide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: no line is long enough for {v2} cells of {v3} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: no section is measured over more than {v2} of its circumference, {v3} are needed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: only {v2} cells have enough points, {v3} are needed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: only {v2} of the circumference is measured, {v3} are needed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: only {v2} segments of its sides have enough points, {v3} are needed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: symmetry needs two planes, two parallel axes, or two centres</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the axis runs parallel to the plane and does not meet it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the axis {v2} is perpendicular to {v3}; its projection is a point: use their intersection</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the nominal looks like {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the planes are parallel and do not meet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the points look like {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the three planes do not meet in one point: two are parallel, or all contain one direction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the {v2} is not determined, most trials with simulated noise fail</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} and {v3} are {v4}° from parallel and have no axis of symmetry</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} is a {v3} and no point: intersect or project it first</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} is undefined, as {v3} ({v4} end)</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.pipeline</name>
    <message>
      <source>Add `nominal = "FILE.stl"`: points are predicted on it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add board views or a cameras.json to the recording, and import it again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add it on the page Inspect, or scan with a part program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add it on the page Inspect.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add one of them to the recording.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate again with this version.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate again, or set when_exceeded = "warn" in the rig's calibration_rules.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate first: measureapp process PROJECT.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate into a new project, or use the rig description with which this one was made.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate into a new project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the rig first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check permissions and space, or choose another folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the images and their manifests.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check where the part stands, and the exposures.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a new or an empty folder for the joined project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a new or an empty folder for the project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose another folder, or delete that one first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one of {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the views in the project of their set-up, then compute this one again: measureapp process PROJECT.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cloud of {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compute it again: measureapp process {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compute its clouds by `measureapp process PROJECT`, or record what is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connect its disk again or restore the folder, then continue the scan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connect its disk again, or restore the folder from a backup.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct bit_depth in the rig description; images of 10 or 12 bit are stored with 16.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct cameras.json.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the size in the rig description, or give the images of this camera at this resolution.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Disconnect the rig first; it is then connected as the task needs it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Draw one camera only: --camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give ROW,COLUMN,ROW,COLUMN of two corners within {v1} rows and {v2} columns.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a new or an empty folder for the project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a project that calibrated its rig, or calibrate first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give every position of the board once.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give images of one resolution, that of the calibrated camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give it one on the Inspect page, and measure again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one: --rig RIG.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give stacks of one projector, or its size by --projector-px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Import into a new folder, or delete that one first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Import one with `measureapp import`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Install the program again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep fewer points: a larger --every.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure it first: measureapp process {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name a project of this rig, or omit the calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name one of: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name one: --nominal FILE.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name projects of one part; if this is one part under two names, add --one-part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name the projects of its set-ups instead.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name their cameras.json.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No viewpoint gives a cloud; the reasons are stated above.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No viewpoint of the plan {v1} gives a usable cloud of this part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only one set-up is named.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plan the scan first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plan the scan first: a template is a start for scans.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Put the board of the calibration on the table, facing the head, and light it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Raw images of {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recompute it: measureapp process {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record vertical and horizontal fringes on the board at {v1} positions at least, better 12, tilted differently.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recordings of other rigs have none; plan a new scan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore it from a backup, or join the set-ups again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Run `measureapp process PROJECT`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan first, or recompute it: measureapp process PROJECT.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan the part first, or restore the project's folder `stacks`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan the part, or compute them from stored images: measureapp process PROJECT.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan the part, or compute them: measureapp process PROJECT.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stored are: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take them first, or give a calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The board views of {v1} do not determine a rig any more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The calibration of {v1} does not name its images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The calibration of {v1} is needed to match their images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The cameras do not make a rig: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The connected rig ({v1}) is described differently than the rig of this task ({v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The image {v1} of the board, from which {v2} was calibrated, {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of camera {v1} in {v2} are {v3} × {v4} px, not {v5} × {v6} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of {v1}{v2} were stored in {v3} and are gone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The part program {v1} has no rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The plan has no viewpoint {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The project folder {v1} is gone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The region {v1},{v2},{v3},{v4} is not inside the images of camera {v5}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The sample project {v1} is damaged: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The sample would have {v1} MB.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The set-ups have no nominal to be joined by.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The view has no camera {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are no images of the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no pattern set {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no sample project {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no set-up {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no view {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use --resume to take only the missing viewpoints, or scan into a new project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use a stack taken by a rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Views {v1} and {v2} of camera {v3} are the same image: it would count twice.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>board view {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>compiling: {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>holes explained</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>holes of {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>improvements predicted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>measured by {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>measured samples</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>noise measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>predicting {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>reading clouds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>reading the nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>reconstructing the surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>samples of the nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>trying {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>viewpoints to be tried</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>views predicted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} ({v2}) is not ready: {v3}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} and {v2} are of different parts: {v3} and {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} are of different parts: {v2} and {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be written: {v2} × {v3} px is too large for PNG.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be written: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains another project ({v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains another recording, or an earlier state of {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains images already.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains no images of the part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains no images of view {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains no images of viewpoint {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains no measurement.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} from {v2}. {v3}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has images of camera {v2}, which is not calibrated.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has neither a calibration nor images of the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has neither board views nor known cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no axis read-back.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no calibration, which is needed for points.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no clouds yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no nominal.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no results.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no scan plan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} have different inspection programs ({v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a project of {v2}, which is described differently than {v3} is now.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is damaged: it is not the file that was joined.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is itself joined from several set-ups.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is joined from several set-ups.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is named twice.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} names no nominal.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} positions of the board do not determine the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} proposals</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} was made with another board ({v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} was measured without an inspection program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} was not imported from a recording.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} were compared with different nominals.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} has {v3} bit, the rig's camera {v4} has {v5} bit.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} is {v3} × {v4} px, the rig's camera {v5} has {v6} × {v7} px.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.planning</name>
    <message>
      <source>A plan needs at least one viewpoint.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A stand-off of {v1} mm is impossible.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add another one before you remove the last.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>An elevation of {v1}° is impossible.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>An order names every viewpoint once; {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>At this step {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change these viewpoints or their order; nothing was moved.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change these viewpoints; nothing was moved.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the pose of the part on the table and the rig's limits.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a distance above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose another name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose another place, or turn the part over for a second set-up.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one of them to change its pose or table angle.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose {v1}…{v2}°.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct its pose on the table.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the order.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct them: links in the robot's file, other bodies in [cell], keep-out boxes in [motion] of the rig description.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export it again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Group {v1} has several viewpoints.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Group {v1} repeats {v2} poses at {v3} table angles; single ones of its viewpoints cannot be removed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move another way; nothing was moved.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move it to the centre of the table; if it may overhang, state largest_part_mm in [cell] of the rig description.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing was changed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only groups can be ungrouped.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only single viewpoints can be made a group.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rename the group, or ungroup it first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Request at least 1.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>See `measureapp plan show` for its names.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Select single viewpoints, or ungroup first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State its unit if it is not in millimetres.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State the unit of the nominal if it is not in millimetres, or lay the part down.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State the unit of the nominal if it is not in millimetres, or move the part to the middle of the table.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The bodies {v1} touch whatever the joint angles: the model of the cell is wrong.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The name {v1} is taken.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The nominal has no surface: all its triangles are degenerate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The nominal has no triangles, or corners that are not finite.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The nominal is {v1} mm long, too small to be measured.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The part is too large for {v1}: turning with the table it needs {v2} mm, and parts may have up to {v3} mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The part is too large for {v1}: turning with the table it needs {v2} mm; {v3} mm are allowed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The part is {v1} mm high; the robot of {v2} reaches {v3} mm above the table.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The part reaches {v1} mm below the top of the table.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The plan exceeds the limits of {v1}: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The plan has no viewpoint or group {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The plan is not free of collisions. {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Their product may be {v1} at most.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This is impossible: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ungroup it first, or remove all viewpoints of a pose or of a table angle.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Write a plan for this part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>reach and collisions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>viewpoints for pockets</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>what cannot be seen</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be a name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot measure any of the part: none of {v2} feasible viewpoints sees it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot reach a viewpoint of this part at or near an elevation of {v2}°.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a single viewpoint.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is named after its group {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} reaches no viewpoint that sees this place of the part at less than {v2}° to its surface normal.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} samples and {v2} candidates need too much memory.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} viewpoints chosen</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} viewpoints were requested.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} viewpoints, exchanges</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.project</name>
    <message>
      <source>--alignment {v1}: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>--images names camera {v1} twice.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>--images {v1} names no camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A projector of {v1} × {v2} px is not supported.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A release needs a name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A six-axis arm is needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A temperature of the board says nothing without its class or certificate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add a second pitch or a Gray code.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add limits (lower, upper, velocity) to every revolute joint.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add projector_px (projector_rows for horizontal fringes).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the grey level of a saturated pixel: 1023, 4095 or 65535.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the missing images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the shifted sinusoids.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add {v1} at the top of the file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate again, or delete this file to continue without it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the rig into this project first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check memory and disk of the computer.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the folder and its permissions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the folder and quote the pattern.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the path in the manifest.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the path.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the permissions of the folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the permissions, or choose another folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the permissions, or copy the folder to a disk of your own.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the size given in [board], the unit of the certificate (mm), and that it numbers the marks row by row from 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a folder outside the project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a folder that exists.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a folder with a shorter path.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a new or an empty folder for the copy.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a new or an empty folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one of its features or dimensions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one with {v1} or more digits or letters.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the certificate of this board, or correct the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the folder that holds the fringe images of the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the folder that holds the images of the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Convert the positions from metres to mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy or record it again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy the file again from where it was written.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy the mesh there, or correct `nominal`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copying {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct it, or delete it and set operator mode up again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct periods or {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the axis of this joint.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the line named.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the paths, which are relative to the manifest's folder, or copy the images there.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the value.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct this attribute.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct this entry of the inspection program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct this entry of the plan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct this field.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct this line.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Delete the DOCTYPE from the file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detect the corners again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>End its name in .toml or .json.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export or copy the file again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export the arm alone, without gripper, guide or second arm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export the part again as OBJ with a mesh in it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Filter it again on the page Clouds.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Free some space or choose another folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Free some space, or choose another disk.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give 4, 5, 8, 12 or 14 coefficients in OpenCV's order.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give [[fx, 0, cx], [0, fy, cy], [0, 0, 1]] in pixels.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a PLY, STL, OBJ or STEP file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a cameras.json written by `measureapp calibrate cameras`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a file with one point (x y z) a line.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a file written by `measureapp calibrate cameras`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a file written by `measureapp response`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a file, or one of: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a mesh, or make one of the cloud first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a new or empty folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a rig description (TOML), or one of: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give at most {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give comma-separated values in UTF-8.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give each exposure once.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give every camera the same images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give it as 2026-05-04 or 2026-05-04T10:20:30+02:00.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give it in °C with its uncertainty (k = 2), such as 21.5±0.5.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give labels such as "left.fx" or "right.x_mm".</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give names with numbers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one image of every camera per board position.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one pattern per camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give one value, at the top of the file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the angles of all positions, or none.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the arguments of the command as strings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the file of an arm (TOML or URDF), or one of: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the image's size in pixels.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the images of one camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the path of a cameras.json.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the picture of the part as PNG.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give the projector another name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give x, y and z on every line.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give {v1} to {v2} px for width and height.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give {v1}, at the top of the file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give {{"left": {{…}}, …}}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} cannot be decoded.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} cannot be read: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} differs from {v2} in size or bit depth.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} has {v2} bit, {v3} has {v4} bit.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} has {v2} pixels.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} has {v2} × {v3} px, {v4} has {v5} × {v6} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image {v1} is truncated: its end is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Install it with `python -m pip install {v1}` in MeasureApp's environment, or export the part as STL.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Its 3×3 part must be a rotation; lengths in mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Its last row is 0 0 0 1; lengths in mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Leave the unit of the nominal out.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Leave the unit out.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Link {v1} is not between {v2} and {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Link {v1} is the child of several joints.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure the part with an inspection program first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured results are kept; measure the part again and state why.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name a .ply file for the coloured nominal.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name a file of the project, such as inspection/program.toml.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name a file that ends in .csv or .json.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name a file that ends in .svg.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name a folder that contains a {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name a link of the chain as base.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name best-fit, none, or a file with a 4×4 matrix.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name each parameter once.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name every camera in every group.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name its cameras: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name project folders, or folders with projects in them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name the link of the flange, one of: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name {v1} images, in order.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No file matches {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No image matches {v1} for camera {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No images were given.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No joint ends at a link {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No manifest matches {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number the corners the same way at all positions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number the marks from 0 row by row, all with the same position.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only open chains are supported.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Only revolute joints with limits, and fixed ones, are supported.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open it with that version.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open it with the version that wrote it, or a later one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open the project with that version.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Point the cameras at a stationary surface with bright and dark areas, and measure again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Process it once with this version.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Put the pattern in quotes and check the folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Read it as plain points, or process the project again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Read it as plain points, or stitch again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recompute them: measureapp process PROJECT.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record all images with one bit depth.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record the same patterns at every exposure.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Record vertical and horizontal fringes at every position, for example a set named …-both of `measureapp patterns export`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reduce the cloud or mesh first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove the field, or calibrate again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore both of its files from a backup, or calibrate again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore it from a backup, or import the recording again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore it from a backup, or take the position again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore it from a backup, or write a new one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore the file from a backup, or create a new project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore the file from a backup.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save it as ascii or (uncompressed) binary PCD, or as PLY.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan into a new project, or only add viewpoints.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan the part again to compute it anew.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sections cannot be written as {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>See the format of cameras.json in the help.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Serial number {v1} was measured before ({v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State --board-class or --certificate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State one of them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State who releases the part program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stitch again, or copy the file again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Store it in the series of its own program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Store only stacks taken by a rig in a project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take at least two images of each of several brightnesses.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take at least two images of every brightness in constant light.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take the view again, or restore the file from a backup.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take the view again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take this viewpoint again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Temperature of the board: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The 3×3 part must be a rotation without scale or mirror.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The PIN has fewer than {v1} characters.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The calibration in {v1} was modified after it was stored.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The cameras have different numbers of images ({v1}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The copy needs {v1} GB, and {v2} has {v3} GB left.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The image of camera {v1} cannot be encoded.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of {v1} were removed to save space.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The inspection program has no entry {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The inspection program is not valid TOML: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The joints form a closed loop.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The noise model does not fit: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The path of {v1} is too long: it exceeds {v2} bytes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The results in {v1} cannot be read: {v2}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig of {v1} has no camera {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The root element is &lt;{v1}&gt;, not &lt;robot&gt;, as in a URDF.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The run is of program {v1}, not {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The stack of {v1} has no axis read-back.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are no images in {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are {v1} revolute joints {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no folder {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no rig {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no robot {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no {v1} in {v2} or its subfolders.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Too many wrong attempts. Wait {v1} s.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use .ply or .stl.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use .ply or .xyz.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use every image once.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use images of one size for each camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use the calibration of the camera that took the images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use the version of MeasureApp that wrote it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait until it has finished, or close it; then try again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait until that has finished, then try again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Write --images left='folder/left*.png'.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Write the file again with this version.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Write the manifest as `measureapp decode --help` describes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} and the class {v2} both state the lengths of the board.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} and {v2} are both image {v3} of camera {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be read as a part program: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be read as a report template: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be read as an alignment: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be read as {v2}: {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be written to.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be written.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot hold a mesh.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains another file: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains images of another plan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains noise models that do not fit their camera ({v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} contains {v2}, which no part program has.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} could not be compressed without loss, and stays as it is.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} could not be tessellated: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} declares a document type (DOCTYPE), which can hide entities.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} differs from the group of the longest exposure.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not describe a stack: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not end in .ply.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not exist or is not a file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not hold a calibration: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not hold numbers only.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not hold the 16 finite numbers of a 4×4 matrix.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not hold the corners of a camera calibration: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not say whether it is ascii or binary.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} ends with its header.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} gives different {v2}: {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has a header that cannot be understood ({v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has a line in its header that cannot be understood: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has a line without two numbers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has a number that is not finite.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has a triangle that does not have three corners.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has a vertex that is not three numbers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has an axis of length 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has different numbers of images ({v2}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no checksums.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no columns level and grey.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no evaluated dimensions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no fields x, y and z.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no journal yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no parent or no child link.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no phase-shift group.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no read-back: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no rows of values.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no vertices with x, y and z.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no vertices.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no viewpoint {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has no {v2} in &lt;{v3}&gt;.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has points but no triangles.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has points of views that it does not describe.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has the unknown format {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has triangles whose corners do not exist.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} GiB, more than can be read at once.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} fringes only; the projector calibration needs both directions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} images and needs at least {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} images but {v3} = {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} vertices that are not usable numbers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2}; a certificate of the {v3} has one position with {v4} marks.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} holds more than a report template.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} holds no points.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} holds something that is not a number.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a STEP file, which states its unit itself.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a STEP file; the library that reads it is not installed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is a plan of version {v2}; this version of MeasureApp reads versions up to {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is being written by another program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is cut short: it declares {v2} of element {v3} and holds fewer.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is cut short: it declares {v2} points and holds fewer.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is cut short: it declares {v2} triangles and holds {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is cut short: its last line is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is damaged: what it says of its views' errors is not whole.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is damaged: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is empty.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is in use by another program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is in use by another window or command: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is inside the project that is copied.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is larger than {v2} MB.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is locked by another program, for example a backup.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not JSON.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a CSV file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a MeasureApp project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a PCD file, or its header is damaged.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a PLY file, or its header is damaged.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a PNG image.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a STEP file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a certificate of the {v2} with {v3} mm from mark to mark: a mark is {v4} mm from its place in the grid.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a date or time.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a file that can be accepted.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a noise file: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a readable image.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a rigid transform: {v2}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a stitched cloud written by MeasureApp.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a text file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a view's cloud written by MeasureApp.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not an STL file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not an SVG file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not the name of a plan file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not valid TOML: its values are nested too deeply.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not valid XML: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is of an unknown kind.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is of type {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is stored as {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is the certificate of a board of {v2} × {v3} marks, {v4} mm apart; this is a {v5}, {v6} mm apart.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is the only image of its brightness ({v2} grey levels); the nearest, {v3}, has {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is the only image.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} moves, but is not {v2}: the chain branches.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} names the image {v2} more than once.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} names {v2}, which is no image file of this viewpoint.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} nests more than {v2} elements.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} says of its views what is not a number.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} unpacks to more than {v2} GB.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} unpacks to more than {v2} MB.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} was not tessellated within {v2} s.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} was written by MeasureApp, in millimetres, not in {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} was written by a newer version of MeasureApp (format {v2}; this version reads format {v3}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} was written by a newer version of MeasureApp.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} {v2}: the stitched cloud is shown unfiltered.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, camera {v2} was calibrated for {v3} × {v4} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, line 1: the column {v2} is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, line 1: the column {v2} is unknown or occurs twice.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} cannot be understood.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} is not a point.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} values under {v4} columns.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} values where a point needs {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, line {v2}: {v3} values where line {v4} has {v5}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, line {v2}: {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}, the nominal named in {v2}, does not exist.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: 16-bit images need `saturation`.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: `periods` needs `{v2}`, the length they extend over.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a cloud cannot be written as {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a group of horizontal fringes has projector_px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a mesh cannot be written as {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a single pitch of {v2} px leaves the period ambiguous.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: board_lengths.{v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: cameras names no camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: covariance.matrix is not a covariance matrix: it must be symmetric and positive semidefinite.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: covariance.parameters has a label without a known camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: covariance.parameters names a parameter twice.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: exposure {v2} µs has {v3} groups, the first has {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: image {v2} cannot be read: it does not exist{v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: no corner is common to all positions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: no position is further than {v2} mm from the origin.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: only {v2} of {v3} positions have an angle.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: projector.name is {v2}, the name of a camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: saturation = {v2}, but the images have {v3} bit.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: schema_version is {v2}, not 1 or {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the cameras have images of different bit depth.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the groups of exposure {v2} µs have different cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the reference camera {v2} is not among the cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: two exposures have the same exposure_us.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} does not match its checksum.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} has the unknown field {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} is not a JSON object.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} is not a rigid 4×4 transform.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} is not a rigid transform.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} is not a text.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} is not {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} periods over {v3} px give a pitch below 2 px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2} pitches need projector_px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}.arguments is not a list of strings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}.blur_px is {v3}, not 0 to {v4} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}.distortion has {v3} coefficients.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}.matrix is not a camera matrix.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}.reference_from_camera is not the identity for the reference camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}.width and height must be whole numbers above 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}.{v3} is not a number.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}={v3} is not numeric.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}={v3} should be {v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: {v2}{v3} is missing.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}; the first image of camera {v2} is {v3} × {v4} px.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.projector_lightcrafter</name>
    <message>
      <source>Check exposure, period and trigger settings against its manual.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check its power and its USB cable.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the USB cable, and close other programs that use the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close other programs that use it; on Linux, allow access by a udev rule (see the README of the driver).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close other programs that use the projector, and check the limits in its manual.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close other programs that use the projector.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the rig description, or choose another driver.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the setting flash, or program the images with the vendor's tool.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the setting flash.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the setting video.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export it by `measureapp patterns export --width {v1} --height {v2}`, program the images with the vendor's tool, three patterns to an image (green, red, blue), and add hash {v3} with their numbers to the setting flash.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give 8-bit images of {v1} × {v2} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Load them with this driver's model.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name one of them in the setting serial.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Play again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig {v1}: the projector has {v2} × {v3} px, and a LightCrafter 4500 {v4} × {v5}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig {v1}: the settings of the screen at the video port: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set the screen to a frame time of {v1} µs or more, such as 60 Hz.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop other programs that use the projector; if it stays so, switch it off and on again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Switch it off and on again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Switch it off and on again; if it stays so, it is defective.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Switch it off at its power supply.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Update its firmware.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Update its firmware; this one takes the command for one run as the one for repetition.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} did not start the sequence: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} did not switch its light off.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} did not take over the setting {v2}: {v3} was written, {v4} was read back.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not accept the sequence: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not support images of shape {v2} and type {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} images and cannot play {v3}…{v4}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} images and cannot show image {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} has {v2} images in flash, and the settings name others ({v3}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} refused {v2} ({v3}; reply {v4}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} reports a fault: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} reports a fault: {v2}. The number of its trigger pulses is unknown.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} returned an empty table of {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} still plays {v2} s after the start of a sequence of {v3} s: it repeats the patterns, and the number of its trigger pulses is unknown.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} stopped {v2} s after the start of a sequence of {v3} s: the number of its trigger pulses is unknown.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a reply to {v2} has the sequence number {v3} instead of {v4} ({v5}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: a reply {v2} ({v3}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the LightCrafter is present and cannot be opened: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the pattern set of {v2} images ({v3}) is not in its flash (declared: {v4}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the pattern set {v2} ({v3}) has {v4} images, three to a flash image, and the settings name {v5} flash images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the screen at its video port has a frame time of {v2} µs, too short for 8 bits.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the settings are not those of a LightCrafter.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: there is {v2} on the USB (found: {v3}).</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.projector_second_screen</name>
    <message>
      <source>Check that the program has a display (not over ssh), and that PySide6 is installed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig {v1}: the settings of the projector name no screen.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set frame_us, such as 16667 for 60 Hz.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set name, manufacturer, model or serial; `python -m ui.second_screen list` prints the screens.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the screen does not state its refresh rate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the settings are not those of a second screen.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.reconstruct</name>
    <message>
      <source>A camera of the pair looks along the baseline.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A rectified grid needs two cameras, not {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the images of a second camera.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} and the projector give no points: {v2} pixels are {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has no pixel in row {v2}, column {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} has no pixel with a phase.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} is calibrated for {v2} × {v3} px, its images have {v4} × {v5} px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {v1} is not in the calibration of {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cameras {v1} and {v2} are at one place.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cameras {v1} and {v2} have no epipolar line in common.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cameras {v1} and {v2} look along their baseline.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check shift_sign, the pitches and that the calibration belongs to these images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the calibration.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the grid of the images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Decode the images of one pattern set.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exclude one of the cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exclude one of them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fringes of this direction cannot match the cameras {v1}: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give cameras.json a projector, or use two cameras.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Its images have {v1} rows and {v2} columns.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Project fringes of the other direction, or both.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The image has {v1} columns; at least {v2} are needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images of camera {v1} have {v2} columns; at least {v3} are needed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The phase maps of the cameras are of different pitches.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The region has no pixel of camera {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use images of the whole sensor.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use larger images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use the calibration of the camera and resolution that took the images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>filling {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>matching {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} calibrated camera has images; points need two.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.register</name>
    <message>
      <source>Give each axis from the smaller to the larger value.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Separate the numbers by commas.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The box is empty: a lower limit exceeds its upper limit.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The filter {v1} needs {v2} numbers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The filter {v1} removes all points.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are {v1} filters already.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo some, or apply fewer and stricter ones.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Widen it. Nothing was changed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>building the search tree</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>filter: {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>finding the position of {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>joint registration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>preparing set-ups</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>preparing views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>registering pairs of views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>removing long triangles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>searching neighbours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>surface complete</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>triangulating the points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>trimming the surface</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.report</name>
    <message>
      <source>Add measured projects: measureapp series add PROJECT.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the path of the logo.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct `layout` in {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct this entry of the template.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>End its name in .png or .svg.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give a PNG, JPEG or SVG file of at most 5 MB.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The series of {v1} has no runs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not exist.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not a logo that a report can show.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is not the name of a picture.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the report template has an error: {v2}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.resources</name>
    <message>
      <source>Check the name; if it is correct, the installation is incomplete: install again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The program has no file {v1}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.robot_abb</name>
    <message>
      <source>A message of the pose stream is invalid ({v1}): {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the address is that of the robot's controller, and the version of Robot Web Services.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check that the robot alone sends to this port.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the address, or correct system_id in the robot's settings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the mechanical unit and task in the settings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the version of Robot Web Services.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a free port in settings and controller.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the model of this arm in the robot's settings; check tool0 and the base frame in the controller.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close that program. If it has ended without releasing the robot, switch on take_over in the robot's settings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connect again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct user and password, or the version of Robot Web Services, in the robot's settings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter the fingerprint of the controller's certificate in the robot's settings, after comparing it at the controller.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller at {v1} is system {v2}; the settings expect {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller at {v1} refuses user {v2} (401).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller did not carry out {v1}: it reads back something else.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller has no module of this program: {v1}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller's answer to {v1} has no {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller's answer to {v1} has {v2} in place of a number.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller's answer to {v1} is empty.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller's answer to {v1} is invalid ({v2}): {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller's certificate is not accepted: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller's module is another one: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller's module is version {v1} ({v2}); this program needs {v3} ({v4}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The controller's pose has a quaternion of length {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The robot is used by another program (computer {v1}, process {v2}); this one may only read.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>UDP port {v1} for the pose stream cannot be opened: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait until the move has ended.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>mm_answer of the controller has {v1} numbers instead of 5: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>mm_answer of the controller is invalid: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>mm_cmd of the controller is invalid: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>mm_owner of the controller is invalid: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} is moving already.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the controller's pose is {v2} mm off the one of kinematic model {v3} for the same joints.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.robot_generic_tcp</name>
    <message>
      <source>A reply of the robot at {v1} is invalid ({v2}): {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check address and port, and the robot's program against the README of the driver robot_generic_tcp.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Correct the robot's program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Install the fitting version of the robot's program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Known are {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The robot at {v1} speaks version {v2} of the line protocol; this program speaks {v3}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} reports the unknown state {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: the quaternion read back has length {v2}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.table_serial</name>
    <message>
      <source>Check its emergency stop and interlocks.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check port, address, baud rate and command table.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the controller, its command table, address and baud rate.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the port, and that no other program uses it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose limits less than 360° apart in the rig description.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name one of {v1}, or the path of a table (.toml).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no command table {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} answered the query {v2} with {v3} ({v4}), which is no reply of a {v5}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} at {v2} did not repeat {v3} ({v4}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} at {v2} sent no valid reply ({v3}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be opened: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} cannot be read as a command table: {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not identify itself as a {v2}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1} does not switch its motor on.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{v1}: its controller counts modulo one turn, and the limits {v2}…{v3}° do not determine the turn.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>core.virtual_rig</name>
    <message>
      <source>Name cameras of this rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Request one of: {v1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The virtual rig has no {v1} to put on the table.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Virtual rig: setting world.knocked_deg names camera {v1}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>images</name>
    <message>
      <source> &amp;nbsp; </source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, no values</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Absolute phase</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Amplitude of the fringes at the exposure used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Column [px]</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Column of the first end</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Column of the second end</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Distance [px]</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From row</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Grey level</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Image</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Longest exposure in which the pixel is not saturated</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Map</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Modulation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Phase</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Phase within one period of the finest fringes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Profile</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reason</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Row [px]</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Row of the first end</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Row of the second end</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save table…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard deviation of the absolute phase</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard deviation σ of the phase</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stored images, one by one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The values of all maps along the line, as CSV</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Valid</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Why a pixel has no phase</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wrapped</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wrapped phase</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>body</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>caption</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>grey levels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>soft</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>to row</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{text}, image {text_2}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{words}, {count} pixels{ends}</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>inspection</name>
    <message>
      <source>   magnified x {gain}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source> {lost} points lie farther than {search_mm} from the nominal.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, each confirmed by its neighbours.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, form {form_error_mm}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>; free: {list}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A plane fixes three degrees of freedom, a line or axis two more, a point the last one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A, B and C in their order; each fixes what the earlier ones leave free.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add a dimension to the inspection program, from features of the list</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add a feature…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add dimension</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add it to the inspection program and measure it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the proposed dimension to the program and measure it (Enter)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add to the inspection program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Added to the inspection program, it is measured every time; its lines can also be copied to another program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Align by datums, 3-2-1 or reference points. To keep the best fit, state it in the text of the program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Align by these elements and measure everything again; it can be undone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Aligned by</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Alignment</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Alignment of the program changed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All points as close to the nominal as possible. For comparison only: it spreads defects over the whole part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>An inspection program fits features to the measured points and compares their dimensions with the nominal.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Apply</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Average the colours of neighbouring points; values, extremes and the histogram use every point as measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Best fit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the program and measure what has changed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose features here, or click them in the list</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the nominal of the part: a mesh or a STEP file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Circle through the points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click a measured point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click faces of the CAD model as elements, in their order; Esc ends</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click faces of the CAD model to select them as features; Esc ends</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Colour scale stored with the inspection program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Colours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cone angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Construct</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Construct a feature from those selected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy its lines</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy rows</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cut the part by a plane and show the deviations along the section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cutting</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cylinder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cylindricity</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Datums</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Decision rule</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Del</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Delete</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Deviation from the nominal, in mm, on the CAD model or on the measured points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Diameter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dimension</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dimensions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Discard the changes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Each point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edit the inspection program as text: alignment, features, dimensions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edit the nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edit the tolerance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter a number, such as 24.5.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter the nominal value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Expanded uncertainty (k = 2)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>F2 edits a cell, Enter zooms to the features of the row.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Feature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Features</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Features and dimensions in TOML; the help of the Inspect page lists all options.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Filled, not measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>First feature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fit a plane, cylinder, sphere or cone around a point you click</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flatness</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Follows the nominal features</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Form</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Form deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Grow a</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hold Ctrl to select several features.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>In use: {name}, {rms_mm} rms.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inspect</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inspection program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inspection programs (*.toml)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Intersection</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Kind</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Kind of dimension</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Labels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lengths in mm, U for k = 2, verdicts by {rule_name}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Limits as deviations from the nominal. Type ±0.1, +0.1/-0.05, max 0.05, H7 or 2768-m.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Line through the points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lines of {name} copied.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>List</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Maximum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean of the points nearby</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean {mean}, rms {rms}; 95 % within {p95}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure a cloud or mesh by a nominal or an inspection program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure a file…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure everything that is stale</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured minus nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured surface; hatched where it was filled, not measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured value, in mm unless a unit is given</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measuring what has changed…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Merged points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mid-plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Midpoint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Minimum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move down</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No alignment was chosen: a best fit was used, which spreads defects over the whole part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No dimension fits these features together.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No extreme that its neighbours confirm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No inspection yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No tolerance: there is no verdict</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominal value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominal, in italics where it is that of the CAD model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominals (*.stl *.ply *.obj *.step *.stp)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominal…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>None</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Normal to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not measured: {total} of the nominal's surface (not seen {not_seen}, filled {filled}, too far {too_far})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not measured: {unmeasured_share} of the nominal's surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing measured yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Offset plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>On the CAD model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>On the points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Order of the dimensions changed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Order of the report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Parallelism</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Paste them into an inspection program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Perpendicularity</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pick faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Picture</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pitch circle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plane fit around the clicked place</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plane through the points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Point on the axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Position</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Position of the section along the axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Program edited, not saved</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Program…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Projection of the first onto the second</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Proposed dimension</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radius</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading a deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Redo (Ctrl+Y)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reference points, each along its normal; further ones take part by least squares.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rejected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Relative deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove from the program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rename</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reset</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Residual at {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Restore the nominal of the CAD features</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Return to the alignment of the program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Roundness</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save as…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save program, results and report with the project (Ctrl+S)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save the inspection program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save the program to a file of its own</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Search</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Search dimensions by name or kind</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Second feature or datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Section normal to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Select features in the list, or pick faces of the CAD model in the picture. Fitting dimensions are then proposed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Shape</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Shape to grow</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show dimensions whose name or kind contains these words (Ctrl+F)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the value of every dimension in the picture</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smooth the colours for the eye</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Smoothed, radius {radius_mm}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sphere</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stale results: the program has changed since they were measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Status: current, being measured, stale, or not measurable</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Store</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Store colours, range and tolerance band with the inspection program: they are used again here and in reports</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Surface deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Symmetric tolerance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Symmetric tolerance band of the colours in mm; it does not affect verdicts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Symmetry</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The coordinates of the part as they are, without an alignment.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The dimensions appear here when the surface is complete.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The entry was not taken over.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The nominal follows the nominal features again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tolerance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tolerance band ±</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tolerance {tolerance}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Too few features: grow some first</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Traceability</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Typed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Uncertainty budget (k = 2)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo the last point, distance, feature or change of the program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whiskers × {gain}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Width of the zone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Worst verdict first</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Zoom to its features</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>blade section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>circle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>cone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>cylinder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>datums </source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>edge</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>feature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>none: no verdict</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>not determined: {motion}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>problem</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>slot</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>sphere</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>strong</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>to datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>torus</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{chip}: show only these</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} fail</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} not measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} not proven</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} of 6 degrees of freedom fixed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} pass</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} stale</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} without tolerance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{filled}: {filled_2} of the surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{inside} within the tolerance band, {below} below, {above} above.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{kind}, width {millimetres}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name}: residual {off}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{program}. Aligned by {name}, {rms_mm} rms.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{shape_words}, constructed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{what} of {count} dimensions changed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{what} of {name} changed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where}, deviations × {gain}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where}: no intersection</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where}: not measured</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>look</name>
    <message>
      <source>, both directions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>10 images: 4 steps at 16 px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>11 images: 4 steps at 16 px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>12 images: 4 steps at 32, 186.6 and 1088 px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>15 images: 8 steps at 16 px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>16 images: 8 steps at 32 and 33 px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>28 images: 4 steps, each pitch half of the one before, from 17 px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>32 and 33 px, 8 steps</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>8 images: 4 steps at 32 and 33 px.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All {count} pass.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Baud rate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Beam of the guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Bodies in the cell</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Boxes of the head</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera in the head</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cantarell</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one of: {expected}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clearance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Complem. Gray, 8 steps</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Complem. Gray, orthogonal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Complementary Gray</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>DejaVu Sans</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Delay between packets</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Depth discontinuity</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter a finite number</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter a number</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter a value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter a value.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter a whole number</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flying point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Full well</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fusion</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give at least {limits}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Gray code</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Grazing incidence</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Head on the flange</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Height of the floor</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hierarchical</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Isolated patch</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep-out boxes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Largest part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lower corner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured by another camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Must be at least {ge}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Must be at most {le}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Must be greater than {gt}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Must be less than {lt}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No dimension has a tolerance: nothing is proven.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Noto Sans</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Oblique to another camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Packet size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Paper, orthogonal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Paper: 32 and 33 px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Park pose</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Projector in the head</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Quaternion</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reference camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Roboto</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>SF Pro Text</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Segoe UI</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Segoe UI Variable</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Settling time</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Synchronisation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The dimension passes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The program evaluated no dimension: there is no verdict.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no such setting</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Thermal expansion of the head</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This text does not have the required form</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Three close pitches</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Three close, 3 steps</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Three close, 8 steps</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Three close, orthogonal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Three wide pitches</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Three wide, 8 steps</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Three wide, from 32 px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Uncertainty of the scale</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Upper corner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Validity</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Value error, </source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>at 16, 131.9 and 1088 px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>at 16, 17.84 and 18.14 px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>at a rim</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>dimension</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>grazing for a partner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>just now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no tolerance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>partner grazing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>seen by another</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{days} days ago</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{hours} h ago</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{list}, of {count}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{minutes} min ago</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{n} fail</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{n} not measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{n} not proven</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{n} pass</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{n} without tolerance</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>main_window</name>
    <message>
      <source>MeasureApp</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save the log for support</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saving the log</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Send this file to support.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The log is saved to {file}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} – MeasureApp</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>operator</name>
    <message>
      <source>
#operator, #operator QScrollArea, #operator QWidget#clear { background: $window; border: none; }
#operator QLabel { background: transparent; color: $text; font-size: 18px; }
#operator QLabel[op="soft"] { color: $soft; font-size: 18px; }
#operator QLabel[op="strong"] { font-size: 20px; font-weight: 600; }
#operator QLabel[op="heading"] { font-size: 24px; font-weight: 600; }
#operator QLabel[op="title"] { font-size: 32px; font-weight: 600; }
#operator QLabel[op="step"] { font-size: 40px; font-weight: 600; }
#operator QLabel[op="value"] { font-size: 36px; font-weight: 600; }
#operator QLabel[op="error"] { color: $error; font-size: 20px; font-weight: 600; }
#operator QLabel[op="count"] { font-size: 20px; font-weight: 600; }

#operator QFrame#operator-bar { background: $surface; border: none; border-bottom: 1px solid $line; }
#operator QFrame#operator-strip { background: $surface; border: none; border-top: 1px solid $line; }
#operator QFrame#operator-card { background: $surface; border: 1px solid $line; border-radius: 8px; }
#operator QFrame#operator-words { background: $raised; border: 2px solid $line; border-radius: 8px; }
#operator QFrame#operator-words[level="error"] { border-color: $error; }
#operator QFrame#operator-call { background: $amber; border: none; }
#operator QFrame#operator-call QLabel { color: $dark_letters; font-size: 20px; font-weight: 600; }

#operator QPushButton[op] { background: $surface; color: $text; border: 2px solid $line; border-radius: 8px; font-size: 20px; }
#operator QPushButton[op="normal"], #operator QPushButton[op="primary"] { padding: 0 24px; min-height: 56px; }
#operator QPushButton[tall="true"] { min-height: 80px; }
#operator QPushButton[op]:focus { border-color: $accent; }
#operator QPushButton[op]:pressed { background: $accent_soft; border-color: $accent; }
#operator QPushButton[op]:checked { background: $accent_soft; border-color: $accent; }
#operator QPushButton[op]:disabled { color: $faint; background: $sunken; }
#operator QPushButton[op="primary"] { background: $accent; color: $accent_on; border-color: $accent; font-weight: 600; }
#operator QPushButton[op="primary"]:focus { border-color: $text; }
#operator QPushButton[op="primary"]:pressed { background: $accent_pressed; }
#operator QPushButton[op="primary"]:disabled { background: $sunken; color: $faint; border-color: $line; }
#operator QPushButton[op="stop"] { background: $fail; color: #ffffff; border-color: $fail; font-size: 28px; font-weight: 700; min-height: 96px; }
#operator QPushButton[op="stop"]:focus { border-color: $text; }
#operator QPushButton[op="stop"]:pressed { background: $fail_pressed; }
#operator QPushButton[op="quiet"] { border-color: transparent; background: transparent; padding: 0 16px; min-height: 48px; font-size: 18px; }
#operator QPushButton[op="quiet"]:focus { border-color: $accent; }
#operator QPushButton[op="quiet"]:disabled { background: transparent; }
#operator QPushButton[op="key"] { font-size: 28px; padding: 0; min-height: 72px; }
#operator QPushButton[op="key"][low="true"] { font-size: 22px; min-height: 48px; }
#operator QPushButton[op="card"] { text-align: left; padding: 0; min-height: ${card}px; }

#operator QLineEdit { background: $surface; color: $text; border: 2px solid $line; border-radius: 8px; font-size: 24px; padding: 0 16px; min-height: 56px; }
#operator QLineEdit:focus { border-color: $accent; }
#operator QLineEdit[invalid="true"] { border-color: $error; }
#operator QProgressBar { background: $sunken; border: none; border-radius: 12px; min-height: 24px; max-height: 24px; }
#operator QProgressBar::chunk { background: $accent; border-radius: 12px; }
#operator QScrollBar:vertical { width: 24px; }
#operator QScrollBar::handle { min-height: 64px; border-radius: 8px; background: $faint; margin: 4px; }
</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>
The first run of this part counts.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A PIN is set. Type a new one twice to change it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A camera has moved since the calibration: the values may be wrong. Call the engineer.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A measurement is running. Stop it before you close the window.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>About {seconds}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All viewpoints are stored. Hold Resume to compute the result, or start again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Back to operator mode</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Call the engineer</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Capital letters</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Changed since</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Confirmed: part clamped, cell clear</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Delete the last letter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Details</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Done</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Engineer</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Engineer called at {time:%H:%M}. {what}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Engineer's role ends after</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Engineer…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fill in the fields marked *.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>First-pass yield {first_pass_yield}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder of the measured parts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder of the part programs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Go on</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hold for 1 s: part clamped, cell clear</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Identify</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>If it is forgotten: measureapp gui --reset-engineer-pin</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>If the part has not been moved, hold Resume: the measurement goes on with {following}. If it has been moved, start again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images are taken</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>It could not be measured.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>It was clamped wrongly</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>It was reworked</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keyboard</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Last</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Load</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure this part again?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>MeasureApp/parts in your home</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>MeasureApp/programs in your home</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured parts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured {when}: {verdict}. Measure it again as run {number}? All runs are kept; without a reason the first one counts.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured {when}: {verdict}; an earlier run counts: {counted}. Measure it again as run {number}? All runs are kept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New PIN or password</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Next</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Next part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No PIN is set: anyone can leave operator mode. Type one twice, 4 or more characters.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No part program has “{words}” in its name or numbers.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No reason</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No viewpoint was stored yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not measured yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not released</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Once more</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Operator mode</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Operators are offered released programs only. Whatever changes a program makes it a new one, which is released again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>PIN forgotten? Run this command on this computer, then set a new one: measureapp gui --reset-engineer-pin</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>PIN or password</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>PIN or password of the engineer</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Part program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Part programs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pause</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Paused</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pausing…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Progress of the measurement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Put the part in</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Put the part on the table as the engineer has shown you, and clamp it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the part programs…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Release</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Release the selected programs for operators, as their next revision</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Release {revision}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Released by</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Released by {by}, {at}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Released part programs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remarks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Repeat</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Report filed: {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Resume: hold for 1 s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig stopped</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan the code, or type the name or number of the part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Search for a part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Serial number</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Shifts begin at</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the result</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Since {since:%H:%M}: {count}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Space</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>State why this part is measured again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop is not an emergency stop.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images are checked</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images are stored</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The measurement has ended early</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The measurement is being prepared</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The pages are being drawn…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The part was cleaned</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The program states no tolerance.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The program's Stop is not an emergency stop: in danger press the emergency stop of the machine.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The report cannot be shown. It is filed with the part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The result is being filed…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig moves</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig settles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The settings</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The two PINs differ.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no part program in {folder}. Call the engineer.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This file cannot be used.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Which part?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Why is it measured again?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>With a reason the new run counts; without one the first run counts. All runs are kept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Your name</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Your name, printed in every report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>ZXCVBNM,:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>at least {limit}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>at least {limit}, U = {u}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>at least {limit}: {past} too small</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>at most {limit}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>at most {limit}, U = {u}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>at most {limit}: {past} too large</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>clamped again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>part program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>part programs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} not released by the engineer: not offered here.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{elapsed}, about {left} left</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{serial}, measured {when}: {verdict}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{step}: viewpoint {number} of {all}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{stored} of {planned} viewpoints are stored and kept.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>pages</name>
    <message>
      <source>, {direction} fringes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>1 of {counted} pixels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>&lt; 1 of {counted} pixels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A part that was measured on the virtual rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Acquisition time</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Age of the calibration, and what it adds to a length between two views, before registration (k = 2).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All parts fit well: scan next.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Another template…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Assumed modulation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>At least {seconds}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Blur of its images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Board moved by {explained_mm} rms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Brightness</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate automatically…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the rig on the Calibrate page</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the whole rig again, or one part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate the whole rig…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrated {age} · adds {added} (k = 2) {words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrated {age} · check it !</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrated {age} · poor fit ✗</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrated {age}. {judgement}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrating…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera </source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera at {vector} mm on the flange</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera pairs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Camera {who} moved · {error_mm} {mark}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cameras only…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cannot be used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change nothing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the path, the free space and the permissions.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the folder of a report template</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click the first point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click the second point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clip box</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Company</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Contribution to the kinematic position of a point (1 σ)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Contribution, 1 σ</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Deviation from the nominal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Direction {vector}, scale {scale:.6f}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Disk space</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Distance from the merged surface, and σ</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Distance of two single points. A dimension of the inspection program uses thousands of points and has a smaller uncertainty.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Error motions, guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Error motions, table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Estimate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Everything</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>First point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fix the calibration board on the table, then calibrate the whole rig in one automatic run. The cameras alone can be calibrated from recorded images too.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Focal length {matrix:.1f} px, centre ({matrix_2:.1f}, {matrix_3:.1f}) px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Focal length, distortion and pose of every camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Good</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Guard band</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Guide direction over {stroke:.0f} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Guide scale over {stroke:.0f} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hand–eye</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hand–eye, position</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hand–eye, rotation over {standoff:.0f} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Header, template…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Kept in this project, with a company and a logo of its own.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Linear guide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Logo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean and spread over several measurements of this part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure the distance between two points you click</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured by</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Method</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nearest point of the view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No calibration yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No preview.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No preview. Use Open PDF to view the report.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No report yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>None expected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not calibrated</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing to report.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Off</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open PDF</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a sample</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>PNG, JPEG or SVG</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Per viewpoint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pictures (*.png *.jpg *.jpeg *.svg)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pixel (row, column)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Poor</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Poor fit: {list}. Calibrate again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Position on the part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Positions of views are corrected for it; what the poses of the calibration did not show of it is in U</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Predicted performance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preparing picks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Printed in the header of every document, and kept with the results of a series. Empty fields are not printed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Projector</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Properties</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Range</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rendering the pages…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Repeats…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reprojection up to {reprojection_limit_px} rms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Residual</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Residual (rms)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Residual up to {axis_limit_mm}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Residual up to {robot_mm}, twice the robot's absolute accuracy</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Result</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Root sum of squares, as for independent solutions. They are solved together, so a part of it cancels.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Saves a copy to a folder of your choice.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Second point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Select something to see its properties.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Series…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set the box around everything</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show in folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Solution</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Source</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard deviation σ</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard deviations</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Straightness</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Switch the clip box off; its numbers are kept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table axis, position</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table axis, tilt over {height_mm:.0f} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Template</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The board is recorded from many sides. The solutions appear here.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The cameras are calibrated; hand–eye, linear guide and table axis are not. Calibrate the whole rig next.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The connected rig takes all images of the board itself, and everything is solved together</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The report is created when a part has been measured: pictures, dimensions, calibration and settings.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The report is written when the dimensions have been evaluated.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The true geometry of the rig is not known yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Through {vector} mm, tilted by {quantity}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Time</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Together</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Trend and capability over all parts measured by one program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Uncertainty (k = 2)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use the calibration that was accepted without a project{words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use the last one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Verdict</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>View</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Views that measured this point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>With the company and the logo below, for all your projects.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wrong fringe orders</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>added to a length between views (k = 2)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>camera</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>figure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>heading</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>nd,nd-&gt;n</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>report templates</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the header</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>x from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>x to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>y from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>y to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>z from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>z to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{estimate}. Criterion: {lower}{criterion}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{file} cannot be written.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{part_words}, measured {value}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>σ of the column</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>σ of the row</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>plan</name>
    <message>
      <source> % of what the rig can measure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source> viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A plan lists the viewpoints of a scan. Generate one from the nominal of the part, open a file, or add viewpoints one by one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add a viewpoint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add on the part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the present position of the connected rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Aim</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Axes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Azimuth</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Azimuth, elevation, roll</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Begin with one viewpoint aimed at the middle of the table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose patterns</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the nominal of the part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the nominal of the part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the part first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose viewpoints by what they are predicted to measure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click the part where a new viewpoint should look.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Colours of the part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Coverage</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Duplicate the selected rows (Ctrl+D)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Elevation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter the {words}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposures of the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposures, wait</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flange</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flange x, y, z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>For no rotation enter 1, 0, 0, 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fringe pitches</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From long to short, in ms, separated by commas</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From long to short, in ms, separated by commas; empty: those of the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Generate a plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Generate a plan…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Generate…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Guide, table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How many viewpoints measure each place of the part; hatched: none</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measured {share}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measures of the part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>More often</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move down in the scan order (Alt+Down)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move the robot</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move up in the scan order (Alt+Up)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name of the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name, patterns, exposures and waiting time of the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No scan plan yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No scan plan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not measured {percent}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing to redo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing to undo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Once</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a plan…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a scan plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a scan plan (TOML or JSON)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Order all viewpoints so that the axes move least; groups are dissolved</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Part…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Patterns</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Patterns of the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Planning…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Position and direction of the robot's flange, as its controller states them</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Predicted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Predicted coverage {predicted}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Prevents the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Properties of</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Quaternion w, x, y, z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Redo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Redo: {redotext}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove the selected rows (Del)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rename the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rename {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Repeat at table angles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Repeat the selected viewpoints at several table angles, as a group</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Replace the selected group by its viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Robot pose</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Roll</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save the plan as TOML or JSON</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save the scan plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan plans (*.toml *.json)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan with this plan; it is stored in the open project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Select a viewpoint to change it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Select a viewpoint to see its properties.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set exposures</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set the waiting time</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set the {words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set {value}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stand-off</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table angles in degrees, separated by commas:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Target x, y, z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The part in one colour</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The plan is being made.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The quaternion (w, x, y, z) is zero and names no direction.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scan uses this plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This viewpoint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Twice</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo: {undotext}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ungroup</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Until</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use for the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoints are chosen by what cameras and projector are predicted to measure, and ordered so that the axes move little. The plan replaces the one shown; undo brings that back.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait before images are taken, in s; empty: that of the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wait before images are taken, in s; empty: that of the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Waiting time</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Waiting time of the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the selected viewpoint measures; hatched: nothing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where the head looks, from which side, elevation and distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Which no other measures</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Whole plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Write numbers separated by commas.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>about {time_s}, {bytes}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>being checked…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>guide in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>keep-out box</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>ni,ni-&gt;n</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>nothing prevents the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>row</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>table in degrees</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>viewpoint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>x of the flange</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>x of the target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>y of the flange</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>y of the target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>z of the flange</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>z of the target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{rows} selected.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{text!r} is not a list of angles.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{text!r} is not a number.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>repeats</name>
    <message>
      <source>A test needs two values and a stated U</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add at least two projects with dimensions of the same inspection program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the project of one measurement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clamp again before each</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clamp the part again, then continue with measurement {number} of {count}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compare</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Continue</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>End</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Evaluate mean and spread</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Every measurement becomes a project beside the open one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder for the report of repeats</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Larger than U</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean, spread and deviation of every dimension over several measurements of one part, and whether the stated uncertainty explains the spread.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measure no further; what was measured is kept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measurement {number} of {count} is running.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measurements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measurements of one part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not tested</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One part under several names</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a calibrated project with a plan to measure its part again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>PDF, table (CSV) and JSON</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Projects</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Relative</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Repeated measurements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save the report…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Spread</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take the chosen project from the list; nothing is deleted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The part is clamped; begin the measurement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The spread is larger than the stated U explains (chi-square test)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The stated U explains the spread (chi-square test)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Within U</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>measurement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} by the program {program}. {list}</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>rig</name>
    <message>
      <source> {count} could not be loaded.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A link is what several drivers share: a serial line, a gateway, a simulated rig. Drivers name it in their setting “Link”.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Absolute accuracy</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add a link</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All devices are ready.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Allow</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Allow the driver {row.name}?
Folder: {row.folder}
Fingerprint (SHA-256): {seen}
Its code runs with your rights on this computer. If any of its files changes, you are asked again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Allow this driver…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrates a virtual rig with hidden errors, scans the part, stitches the clouds, evaluates the dimensions and writes the report.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibration rules</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cell</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a driver</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a driver.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connect</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connect every device of this rig; nothing moves</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connect the rig to move its axes.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Demo</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Demo on the virtual rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Device</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Discard changes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Disconnect</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Driver</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Drivers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Drivers of your own are folders in {folder}. The computer runs their code: allow only those whose origin you trust.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Drivers, settings, motion rules and nominal values of this rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Drives</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edit rig: {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edit rig…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Enter a name for each link.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exposure of the live images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Find references</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Guide and table find their reference positions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hold a button to move on. Stop is no safety function:
in danger use the emergency stop.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep editing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Let the rig run again, after the cause was removed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Links</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Loaded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Loaded.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Loading the rig…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Measuring head</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Motion</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move by hand</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name of the link</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominal values</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominal values from data sheets. Calibration determines the true values.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not allowed yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not loaded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One for each device</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One for the whole rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a rig description</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a rig description…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Panel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reach</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reach {max_reach_mm:.0f} mm · repeatability {repeatability_mm}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recording: there are no devices</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Release every device</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove the link {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Repeatability</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reset the stop before anything moves.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rig descriptions (*.toml)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Robot</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rotary table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save the rig description</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save to another file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save to {file}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save without comments</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sections</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Shows its folder and fingerprint, then asks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standoff</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The driver has no setting {list}; it is removed when you save.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig description is being read.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig is stopped: {stopped} Remove the cause, check that nothing is in the way, then reset.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig to work with: one that comes with the program, or a description of your own (TOML)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no link {name}. Add it under Links.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There is no such driver.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>These settings are kept as they are and checked when the rig is connected.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Two links have the name {twice}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Version</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Version {version}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What was changed here is not saved yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>by the program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>by the projector</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>device</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>driver</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} not ready.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{low} … {high} mm · repeatability {repeatability_mm}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} has a size of {span:.4g}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} has comments. Saving writes the file anew and deletes them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name}, connected. </source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name}. {count}, projector, robot, guide and table; not connected.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{width_px} × {height_px} px · {focal_mm:g} mm lens · {bit_depth} bit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{words} Folder: {folder}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{words} – not loaded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>⌀ {diameter_mm:.0f} mm · accuracy {accuracy_arcsec:g}″</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>scan</name>
    <message>
      <source>, at least {images_s} for the images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, {failed} failed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, {skipped} skipped.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, {stored} stored</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A new project is made here.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A probe at every viewpoint chooses its exposures; for parts with bright and dark sides</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A probe at the first viewpoint chooses the exposures of all</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A ready-made scan of a sample part on the virtual rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A scan moves the rig from viewpoint to viewpoint, projects fringes and takes images. Choose a project and a plan, or run the demo.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>About {expected_s} left, at most {bound_s}; then the clouds are stitched.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add and scan them</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add these viewpoints to the plan and take them; stored images are kept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All images are taken. The clouds are computed and stitched; Cancel keeps the images.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>As planned</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>As the project states</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>As they were taken; everything can be computed again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Back to viewpoints, images and clouds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Before the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibration of</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check connects the rig and lists what prevents the scan; nothing moves.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check, then scan if nothing prevents it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a rig, a project folder and a plan first</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a viewpoint to see its images, to skip it or to take it again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose project, plan and exposures of another scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose project, plan and exposures.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compare with the nominal, and propose the views that pay</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Compress after the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connect the rig and list what prevents the scan; nothing moves</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Continue the paused scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Do not take the chosen viewpoint, or the present one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Drop after the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Every viewpoint is stored completely or not at all.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Existing project: stored viewpoints are kept, missing ones are taken.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Failed viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fix the part on the table.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder of the project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>For example {value}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Images of {viewpoint_id}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>It must not move until the scan has ended.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep the cell clear.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median standard deviation {median_sigma_mm:.4f} mm.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name of the part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New folder, or an existing project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New projects keep the images as they were taken</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New scan…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No viewpoint or exposure within reach is expected to measure more.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No viewpoint scanned.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominal of the part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>None yet: choose a file, or make one on the page Plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>None: no comparison with CAD</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>None: no dimensions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing has been checked yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing prevents the scan.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing scanned yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Once their clouds are stored; clouds cannot be computed again, for example with a new calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pause as soon as the rig is safe; nothing stored is lost</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pausing: the rig comes to a safe stop…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plan of the page Plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Probe at every viewpoint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Probe at the first viewpoint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Project whose calibration is used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Project with a calibration of this rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Raw images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recompute everything from the stored images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Resume</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Resume the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Retake</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scan plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>See the clouds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set up a scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Skip</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Skipped viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>So far</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start the scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop (Esc) is no safety function: in danger use the emergency stop.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stored</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take the chosen viewpoint again; its images are kept until the new ones are stored</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The exposures of the plan, the same or chosen for every viewpoint there</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig is being prepared…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The viewpoints appear here when the scan begins.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Time for each</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Time for the exposures of one viewpoint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What is missing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What is missing…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>With all of them {expected} are expected.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Without loss; everything can be computed again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>connected by Check or Start</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>viewpoint is</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>viewpoints are</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} stored already and kept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} stored and kept, {count_2} missing are taken</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{done} of {count} processed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{id} is chosen.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{id}: + {share} in {seconds}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{share} is missing: {words}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{split}–{most} decoded</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{sufficient} of the surface is measured, of {accessible} that does not touch the support.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>second_screen</name>
    <message>
      <source>Connect it again, then connect the rig again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Load the pattern set first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Name manufacturer, model or serial number too.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Patterns on a second screen.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set the scaling of this screen to 100 %.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Switch the projector on, and check its cable and its name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use driver and window of the same version.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>any name</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>cover a screen and follow the commands on the standard input</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>of the patterns, px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>print the screens</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>python -m ui.second_screen</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{"id": 0, "do": "quit"}</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>series</name>
    <message>
      <source>95 % interval; σ from {sigma_from}. {remark}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add the open measurement to the series of its program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add this measurement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder for the report of the series</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No series yet. Operator mode files every part; a measurement that is open here is added by the button below.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Overall</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>PDF with run charts, table (CSV) and JSON</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Parts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reason, if this part was measured before</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Run chart: values in order of measurement, with limits and mean; moving ranges below</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Series of parts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Trend and capability of every dimension over all parts that were measured by one program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Within</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>field</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no verdict</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>run</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} by the program {program}: {counts}.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>session</name>
    <message>
      <source>Wait until it has finished, or cancel it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{busy_with} is still running.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>shell</name>
    <message>
      <source>A STEP file is a nominal. Open a measured project first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A tour in seven steps leads through a part that has been measured on the virtual rig, up to its report. Nothing moves.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All views in one frame. Turn the part with the left mouse button; click a point to see where it comes from.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cameras, projector, robot, linear guide and rotary table, real or virtual. Connect them here, and move them by hand.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cancel the running job</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change between light and dark</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a template</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose another file.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose another folder.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose its nominal or inspection program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose the cloud or mesh to inspect</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clouds and meshes (*.ply *.stl *.obj *.pcd *.xyz *.txt *.csv *.asc *.pts)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Commands…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Create the project in a new folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ctrl+,</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ctrl+{value}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dimensions with tolerance, uncertainty and verdict, the worst first, and the deviation from the CAD model in colours.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Discard the edits</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Drop one file or folder at a time.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Duplicate the viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Esc</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Finish</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Free space at {folder}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Go to the page Plan first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Go to {word}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Help for this page</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inspect a cloud or mesh…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inspection</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>MeasureApp cannot use {name}. Drop a project folder, a cloud, a mesh, a nominal, a rig, a plan or a program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Messages</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move the viewpoints down</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move the viewpoints up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New project from a template…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New project…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Next: {lower}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No job is running.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nominals and inspection programs (*.stl *.ply *.obj *.step *.stp *.toml)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One automatic run calibrates the whole rig. The page states what the calibration adds to a length, and when it is due again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a project folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a sample: {words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open a scan plan…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open project…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open recent</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Part programs are chosen in operator mode, from the folder of part programs.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Part: {part_words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Python {split}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading versions and graphics</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recompute from the stored images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Redo the change of the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save a copy as…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save a copy of the project as</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save as a template…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save log for support…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save the project as a template</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Settings…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show me a measured part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show or hide the properties</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start takes all viewpoints while the cloud grows. This one is finished: every viewpoint is a tile.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stay here</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop all axes, lamps and cameras</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stopped</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take the tour</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Templates and part programs (*.mpart)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The clouds</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The project {name} is opened</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig {name} is chosen</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scan plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scan plan {name} is opened</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The viewpoints around the part. They can be generated from its CAD model, checked and edited here.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This is an inspection program. Open a measured project first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This page belongs to the engineer's role.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo the change of the plan</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Virtual rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Welcome to MeasureApp</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What you see is the PDF. Export it, or put your company and logo on it. To measure a part of your own, begin on the page Rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Writing the file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>create make folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>example project learn</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>first start introduction guide learn</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>folder load</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>gear, one dimension is not proven</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>gypsum cross, all dimensions pass</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>halt emergency</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>keyboard keys list</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>manual documentation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>mpart new</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>panel side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>part program mpart</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>ply stl file compare</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>process again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>quit end</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>save as duplicate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>search find palette</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>stop abort</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>support zip versions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>theme night colours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>theme preferences options</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>virtual rig sample example</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>warnings errors log</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} not ready</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{drivers} failed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{file} cannot be written: {value}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} becomes the inspection program of the project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} becomes the nominal of the project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} cannot be read: {error}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} is inspected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} is neither a rig, a scan plan nor an inspection program.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} is not a MeasureApp project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name} is not installed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name}, connected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name}, not connected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{running} is still running. Wait until it has finished, or cancel it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{size} free</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>viewport</name>
    <message>
      <source>3-D view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Above</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Axes, cube, scale and legend</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Backend: {choose_backend}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Below</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Blue – white – red</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Bottom</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Class: {getclassname}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Clipped</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Colour-blind-safe</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Continuous</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy picture</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Down</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edges</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>F shows everything, Shift+F the selection, 1 to 7 the standard views. P changes the projection, E shows edges, T makes the surface transparent, L hides labels, H the furniture. Arrow keys rotate, with Shift they pan; plus and minus zoom. Enter picks the point in the centre.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Front</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Go / no-go</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Home</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inside</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Isometric</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Left</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No data</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No graphics library was found. Backend: {choose_backend}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>OpenGL renderer</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>OpenGL vendor</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>OpenGL version</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Parallel projection</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preparing 3-D view…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rainbow with green band</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Return</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Right</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rotate about this place</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save picture</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save picture for print…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save picture without background…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show everything</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Showing {shown} of {total} points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Showing {value:.1f} of {value_2:.1f} million points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Simplified while turning</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Standard views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Steps</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Swap colours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Symmetric range</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The 3-D view needs a graphics library that is not installed. See Help, Scan: “If the 3-D view stays empty”.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The 3-D view needs a library that is missing ({error}). Run the installer again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Top</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Transparent surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Value of the legend</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>all(lessThan(abs(vertexColorVSOutput.rgb - vec3({}, {}, {}) / 255.0), vec3(0.012)))</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>basic render</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>gdi generic</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>tolerance high</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>tolerance low</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>widgets</name>
    <message>
      <source> · {share} saturated</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source> – too bright</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source># Help

There is no page about “{name}”.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>1 message is open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A name cannot contain {list}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A name cannot end with a dot.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A project belongs to a rig. Choose one on the page Rig first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A sample part, or your own closed mesh; its unit is requested unless it is clearly millimetres</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A tour of the window on a sample project, in seven steps</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add: {field_words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Apply to the merged cloud; the stitched cloud is kept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Board temperature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Box</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Browse…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Capturing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Certificate of the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Certificate {name}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Certificate {number}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Certificates (*.toml *.csv);;All files (*)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Certificate…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Certified marks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change between the light and the dark theme</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Checkerboard</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Checking</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a mesh of the part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose one on the page Rig first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose where the project is made</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Chrome on glass or ceramic</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Circles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Circles in a row</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click a pixel to explain it. The wheel zooms, dragging pans, the arrow keys move by one pixel.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click a viewpoint to show its images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close the settings</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Close this message, because its cause is gone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Copy all messages as text</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Create</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dark</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Dictionary</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Do what helps</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>End the tour</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>English</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exact</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fail</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Failed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Film on glass, ± 50 ppm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Flat plate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fold or unfold the properties</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder of your projects</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Forget sizes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Forgotten.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Full</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Gear</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Give window and panels their first sizes at the next start</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Guide {value:.0f} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Gypsum cross</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Half</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Help</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Help for this page (F1)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How well the lengths of the board are known: the scale of everything that is measured with this calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Impeller</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>In the folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>In which unit {words} the {kind}?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inner corners across</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inner corners down</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Inspect a cloud or mesh from a file, against a nominal or by a program</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep running</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep the points inside a box</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep the points on one side of a plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Kept in {file}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Kind of filter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Language</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Least area of a patch to keep, in mm²</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Least number of other points within the radius</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Leave the window open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lengths</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Light</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Like the system</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Limit in standard deviations above the mean distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Loading devices…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Look here</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lower</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Make nothing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Make the folder of the project</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Marker</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Median level {median} · saturated {saturated}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Meshes (*.stl *.ply *.obj)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Messages shown</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Moving</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New, open, copy or close a project; settings; exit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No image yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No project open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No tolerance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not checked yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not proven</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not stated</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of neighbours for the mean distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Of the board in °C with its uncertainty (k = 2), while the images are taken; empty: not measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Operator</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Own mesh file…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pass</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Patches</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Point and mesh files do not contain a unit. All lengths and verdicts depend on it, so it has to be confirmed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Position of the plane along its axis, in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Printed, ± 0.1 mm on 180 mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Processed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Progress of the job</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Quarter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radius in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radius outlier removal, by the number of neighbours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove beyond</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove isolated patches below</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove small isolated patches</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove with fewer than</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Resolution</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Robot x</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Robot y</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Robot z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Row distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rows</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save log, settings and versions in one file; it holds no secrets</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Seed of the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Seen to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set up operator mode: PIN, folders, shifts</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Settings</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Settling</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show all messages</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Side of the plane to keep</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Side view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Skipped</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sphere plate</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Square</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Statistical</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Statistical outlier removal, by the mean distance to neighbours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Step</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Step in mm or degrees</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop all axes, lamps and cameras (Esc). This is no safety function.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop and close</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop at the next safe point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop everything that moves, then close the window</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stopping…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Such as “Housing 4711”</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table ⌀ {value:.0f} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Temperature of the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The seed determines the hidden errors of robot, guide, table and lenses</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Theme</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This cannot be read. {tip}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>This is not a number.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Top view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turn about x</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turn about y</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Turn about z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Unit of lengths</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Upper</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Use this unit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Viewpoints</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Waiting</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What happened</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What to do</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>While a button is held, one step follows the other; the motion ends with the step under way when it is released.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Window</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Write one setting per line, as TOML: name = value. Texts are in quotation marks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a {{ color: {colour}; }}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>above x</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>above y</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>above z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>below x</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>below y</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>below z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>name = value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>neighbours</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>not measured; such as 21.5±0.5</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>others within</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>plan's</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>pose</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{closed} Show</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} cannot be scanned. {tip}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} messages are open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{end} limit of the box along {axis}, in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{finding}: probably {words}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name}, in {words}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{open} Hide</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{time} left</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{title} is still running. Closing the window stops it; everything stored so far is kept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{value} exists already. Choose another name.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{words}
Click to see all messages.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{words} – the longest side is {quantity}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{word} (Ctrl+{value})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>σ over</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>wizards</name>
    <message>
      <source>, {out} not used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A calibration is valid for the temperature at which it was made.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A new project is made.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A run that was stopped is continued.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A simulated rig with hidden errors. The result page shows the true values beside the estimates.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Accept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Accept anyway</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Back to live</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Back to the views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Begin</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrate automatically</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Calibrated and stored in the project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Check the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose a folder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Choose other images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Collect more</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Connect the rig and take the images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Continue it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Corners</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cross-validation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Detected corners; rejected ones in red</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Each view is predicted by a calibration without it: {quantity}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Error</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Evaluating the result…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fix the board in the centre of the table, tilted about 45° towards the robot.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder with images of the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Folder with the images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From the rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Good views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Guide positions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How it was determined</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>It must not move until the run has ended.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Keep the previous one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Let the cameras warm up.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New folder, or an existing project of this rig</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No board found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No camera detects the board from {names}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No rig is chosen: choose one on the page Rig.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not calibrated. Views taken so far are kept; Start continues.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not determined: {what}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Not used yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nothing is missing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>One line per position of the board, in the order of the images. A folder in which a project keeps its views of the board needs no tables: it holds where the axes stood.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Previous calibration</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Redo the change (Ctrl+Shift+Z)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove the chosen view (Delete)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Removed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Robot poses</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>See the result</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Set up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show next</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the newest image again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Start again takes it again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Std. dev.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop after this view; what was collected is kept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop everything that moves; views taken so far are kept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop this check; the result does not change and can be accepted now</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stopped. Views taken so far are kept; Start continues.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Table angles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tables (*.csv);;All files (*)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take one view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take {count}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take {more} more views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The board of this project.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The images appear here as they are taken.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The rig takes about 70 images of one board from all sides. Cameras, hand–eye, linear guide and table axis are then solved together.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The robot brings the cameras to the board. Fix the board on the table first, and keep the cell clear.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The wizard shows what is missing while you collect, and saves every view at once.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>There are enough views. More of them improve the result slightly.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>These views do not determine a result yet.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>True value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>True values are known because the rig is simulated. The measurement never reads them.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undo the last change (Ctrl+Z)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>View {view} rejected: {reason}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Views stored in the project are not taken again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What is still missing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What this wizard does (F1)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where corners were detected so far; the darker, the more often</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where the board should appear in the next view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>With these views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>and {value} more</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>board images</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>corner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>looking for the board</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>more views</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>name,position_mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>name,x_mm,y_mm,z_mm,qw,qx,qy,qz</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>position,angle_deg</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>shows fringes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{caption}
There is no image of this view.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} in use</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} of an earlier session are kept{words}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{count} taken, {kept} stored before.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{rest} more have enough</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{value:.1f} standard deviations</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{viewpoint_id} failed: {reason}</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>workers</name>
    <message>
      <source>A file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stored data is not affected; try again. If it happens again, send {log} in the folder MeasureApp of your home to support.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{doing} stopped by an internal error ({name}: {error}).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{value} cannot be used: {value_2}.</source>
      <translation type="unfinished" />
    </message>
  </context>
</TS>
