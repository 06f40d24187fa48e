<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<!-- The pages of CGAL's manual to which this one links. -->
<tagfile>
  <compound kind="group">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceGraph</name>
    <filename>BGL/classFaceGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceListGraph</name>
    <filename>BGL/classFaceListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>HalfedgeListGraph</name>
    <filename>BGL/classHalfedgeListGraph.html</filename>
  </compound>
</tagfile>
