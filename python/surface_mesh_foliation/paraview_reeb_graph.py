# SPDX-License-Identifier: GPL-3.0-or-later
"""Plugin for ParaView: the filter "Foliation Reeb Graph".

In ParaView, Tools > Manage Plugins > Load New, and choose this file; in a script::

    LoadPlugin("surface_mesh_foliation/paraview_reeb_graph.py", remote=False, ns=globals())
    graph = FoliationReebGraph(Input=reader)

It is not imported by the rest of the module.
"""

import os
import sys

from paraview.util.vtkAlgorithm import smdomain, smhint, smproperty, smproxy

try:
    from surface_mesh_foliation import vtk_filter
except ImportError:  # then the folder that has the module is around this file
    sys.path.append(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    from surface_mesh_foliation import vtk_filter

from surface_mesh_foliation._hierarchy import DEFAULT_MIN_MODULUS  # noqa: E402

paraview_plugin_name = "Foliation Reeb Graph"

# ParaView shows properties in this order; groups have to come after their properties.
_PROXY = """
<Documentation short_help="The Reeb graph of a surface">
  Computes the Reeb graph of a surface by a harmonic measured foliation: the surface with its parts,
  the skeleton with radii, and the nodes. The graph is certified in each run.
</Documentation>
<OutputPort index="0" name="Surface"/>
<OutputPort index="1" name="Skeleton"/>
<OutputPort index="2" name="Nodes"/>
<IntVectorProperty name="FindPoles" label="Find Poles" command="SetFindPoles"
                   number_of_elements="1" default_values="1">
  <BooleanDomain name="bool"/>
  <Documentation>
    Find poles at the ends of limbs, besides those that are given below.
  </Documentation>
</IntVectorProperty>
<IntVectorProperty name="Poles" command="AddPole" clean_command="ClearPoles" repeat_command="1"
                   number_of_elements_per_command="1" animateable="0">
  <Documentation>
    Points that are poles, by their ids in the input.
  </Documentation>
</IntVectorProperty>
<DoubleVectorProperty name="PolePositions" command="AddPolePosition"
                      clean_command="ClearPolePositions" repeat_command="1"
                      number_of_elements_per_command="3" animateable="0">
  <Documentation>
    Positions x, y, z: the point that is nearest to each is a pole.
  </Documentation>
</DoubleVectorProperty>
<DoubleVectorProperty name="Detail" command="SetDetail" number_of_elements="1"
                      default_values="{detail}">
  <DoubleRangeDomain name="range" min="0.05" max="3"/>
  <Documentation>
    The least modulus, length divided by circumference, of a cylinder that is a part of its own: a
    smaller one gives more parts.
  </Documentation>
</DoubleVectorProperty>
<IntVectorProperty name="HandlesOnly" command="SetStar" number_of_elements="1"
                   default_values="0">
  <BooleanDomain name="bool"/>
  <Documentation>
    Find only loops around handles: without handles, the graph is a star. Detail is ignored.
  </Documentation>
</IntVectorProperty>
<IntVectorProperty name="Openings" command="SetOpenings" number_of_elements="1"
                   default_values="{fill_short}">
  <EnumerationDomain name="enum">
    <Entry text="Fill short ones" value="{fill_short}"/>
    <Entry text="Ends of the graph" value="{keep}"/>
    <Entry text="Fill all" value="{fill}"/>
    <Entry text="Fill up to a length" value="{fill_up_to_length}"/>
  </EnumerationDomain>
  <Documentation>
    What becomes of openings of the surface: each is an end of the graph, unless it is filled. Those
    with a border of at most a twentieth of the diagonal of the bounding box are short.
  </Documentation>
</IntVectorProperty>
<DoubleVectorProperty name="FillLength" label="Fill Length" command="SetFillLength"
                      number_of_elements="1" default_values="0">
  <Hints>
    <PropertyWidgetDecorator type="GenericDecorator" mode="visibility" property="Openings"
                             value="{fill_up_to_length}"/>
  </Hints>
  <Documentation>
    The longest border of an opening that is filled.
  </Documentation>
</DoubleVectorProperty>
<IntVectorProperty name="Repair" command="SetRepair" number_of_elements="1" default_values="0">
  <BooleanDomain name="bool"/>
  <Documentation>
    Make an oriented manifold of whatever the faces form: merge equal points, turn faces over, and
    so on. Otherwise, what is not one is refused.
  </Documentation>
</IntVectorProperty>
<PropertyGroup label="Poles, by Point Id">
  <Property name="Poles"/>
</PropertyGroup>
<PropertyGroup label="Poles, by Position">
  <Property name="PolePositions"/>
</PropertyGroup>
<PropertyGroup label="Loops">
  <Property name="Detail"/>
  <Property name="HandlesOnly"/>
</PropertyGroup>
<PropertyGroup label="Openings and Mistakes">
  <Property name="Openings"/>
  <Property name="FillLength"/>
  <Property name="Repair"/>
</PropertyGroup>
""".format(
    detail=DEFAULT_MIN_MODULUS,
    fill_short=vtk_filter.FILL_SHORT_OPENINGS,
    keep=vtk_filter.KEEP_OPENINGS,
    fill=vtk_filter.FILL_OPENINGS,
    fill_up_to_length=vtk_filter.FILL_UP_TO_LENGTH,
)


@smproxy.filter(name="FoliationReebGraph", label="Foliation Reeb Graph", support_reload=False)
@smhint.xml('<ShowInMenu category="Foliation"/>')
@smproperty.xml(_PROXY)
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkPolyData"], composite_data_supported=True)
class FoliationReebGraph(vtk_filter.FoliationReebGraph):
    """Computes the Reeb graph of a surface."""
