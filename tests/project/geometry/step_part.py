"""A STEP file (ISO 10303-21, AP214) written by hand: an upright cylinder, in millimetres or inches."""

from __future__ import annotations

MM = "#90=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));"
INCH = """#94=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#95=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);
#96=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#94);
#90=(CONVERSION_BASED_UNIT('INCH',#96)LENGTH_UNIT()NAMED_UNIT(#95));"""

TEXT = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('cylinder'),'2;1');
FILE_NAME('cylinder.step','2024-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('automotive design');
#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT('cylinder','cylinder','',(#3));
#5=PRODUCT_DEFINITION_FORMATION('','',#4);
#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#7=PRODUCT_DEFINITION('design','',#5,#6);
#8=PRODUCT_DEFINITION_SHAPE('','',#7);
#9=SHAPE_DEFINITION_REPRESENTATION(#8,#10);
#10=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#13,#60),#93);
#11=CARTESIAN_POINT('',(0.,0.,0.));
#13=AXIS2_PLACEMENT_3D('',#11,#14,#15);
#14=DIRECTION('',(0.,0.,1.));
#15=DIRECTION('',(1.,0.,0.));
#16=CARTESIAN_POINT('',(0.,0.,{height}));
#17=AXIS2_PLACEMENT_3D('',#16,#14,#15);
#18=CARTESIAN_POINT('',({radius},0.,0.));
#19=CARTESIAN_POINT('',({radius},0.,{height}));
#20=VERTEX_POINT('',#18);
#21=VERTEX_POINT('',#19);
#22=CIRCLE('',#13,{radius});
#23=CIRCLE('',#17,{radius});
#24=VECTOR('',#14,1.);
#25=LINE('',#18,#24);
#26=EDGE_CURVE('',#20,#20,#22,.T.);
#27=EDGE_CURVE('',#21,#21,#23,.T.);
#28=EDGE_CURVE('',#20,#21,#25,.T.);
#30=ORIENTED_EDGE('',*,*,#26,.F.);
#31=EDGE_LOOP('',(#30));
#32=FACE_BOUND('',#31,.T.);
#33=PLANE('',#13);
#34=ADVANCED_FACE('',(#32),#33,.F.);
#40=ORIENTED_EDGE('',*,*,#27,.T.);
#41=EDGE_LOOP('',(#40));
#42=FACE_BOUND('',#41,.T.);
#43=PLANE('',#17);
#44=ADVANCED_FACE('',(#42),#43,.T.);
#50=ORIENTED_EDGE('',*,*,#26,.T.);
#51=ORIENTED_EDGE('',*,*,#28,.T.);
#52=ORIENTED_EDGE('',*,*,#27,.F.);
#53=ORIENTED_EDGE('',*,*,#28,.F.);
#54=EDGE_LOOP('',(#50,#51,#52,#53));
#55=FACE_BOUND('',#54,.T.);
#56=CYLINDRICAL_SURFACE('',#13,{radius});
#57=ADVANCED_FACE('',(#55),#56,.T.);
#59=CLOSED_SHELL('',(#34,#44,#57));
#60=MANIFOLD_SOLID_BREP('',#59);
{length_unit}
#91=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#92=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#97=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-05),#90,'distance_accuracy_value','');
#93=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#97))GLOBAL_UNIT_ASSIGNED_CONTEXT((#90,#91,#92))REPRESENTATION_CONTEXT('',''));
ENDSEC;
END-ISO-10303-21;
"""


def cylinder(radius: float, height: float, *, inches: bool = False) -> str:
    """Return the text of the file; radius and height are in its unit."""
    return TEXT.format(radius=f"{radius:.6f}", height=f"{height:.6f}", length_unit=INCH if inches else MM)
