package dev.lazyz.jmh.stages;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * The stage of each method of the library: the one place that says which code belongs to which stage.
 *
 * <p>A rule names a method, a class with its nested classes, or a package with its subpackages ({@code .*}); the
 * longest one that matches is used. Classes that serve several stages have {@code CALLER}: the method that called them
 * decides. A method that is inlined by kotlinc counts as a part of the method that contains it. A test fails if a class
 * of {@link #PACKAGES} has no rule, or if a rule names nothing.
 */
final class StageMap {
    /** Start of the names of classes of this project. */
    static final String ROOT = "dev.lazyz.";

    /** Packages in which each class needs a rule of its own or of its package. */
    static final Set<String> PACKAGES = Set.of("strategies.tiled", "setup", "raster", "shading");

    private static final String CALLER = "CALLER";

    private static final String RULES = """
            setup.VertexStage                                        TRANSFORM
            setup.Clipper                                            TRANSFORM
            setup.planar.SnappedVertices                             TRANSFORM
            setup.planar.SharedVerticesKt                            TRANSFORM

            setup.Viewport                                           SNAP
            setup.ScreenViewport                                     SNAP
            raster.ScreenGrid                                        CALLER
            raster.ScreenGrid.snap                                   SNAP

            strategies.tiled.binning.ArrayPool                       BIN
            strategies.tiled.binning.Arrivals                        BIN
            strategies.tiled.binning.Band                            BIN
            strategies.tiled.binning.BandKt                          BIN
            strategies.tiled.binning.BinArea                         CALLER
            strategies.tiled.binning.BinBounds                       BIN
            strategies.tiled.binning.BinFiller                       BIN
            strategies.tiled.binning.KeyedPlaces                     BIN
            strategies.tiled.binning.NearToFar                       BIN
            strategies.tiled.binning.TriangleBins                    BIN
            strategies.tiled.binning.WideTriangles                   BIN
            strategies.tiled.binning.SmallTriangleKernel             BIN
            strategies.tiled.binning.ScalarSmallTriangleKernel       BIN
            strategies.tiled.binning.VectorSmallTriangleKernel.fetch BIN
            strategies.tiled.binning.VectorSmallTriangleKernel.bound BIN
            raster.VisibilityOrder                                   BIN
            raster.ReachKt                                           BIN

            setup.planar.FaceSetUp                                   SET_UP
            setup.planar.PlanarAssembly                              SET_UP
            setup.planar.PlanarAssemblyKt                            SET_UP
            setup.planar.PlanarSetUp                                 SET_UP
            setup.planar.TriangleBatch                               CALLER
            setup.planar.TriangleBatchKt                             CALLER
            raster.ReferenceTriangle                                 SET_UP
            raster.EdgeFunctions                                     SET_UP
            raster.Edge                                              CALLER
            strategies.tiled.EarlyZDrawing                           SET_UP
            strategies.tiled.raster.FineRaster.begin                 SET_UP
            strategies.tiled.raster.ScalarBlockKernel.begin          SET_UP
            strategies.tiled.raster.VectorBlockKernel.begin          SET_UP
            strategies.tiled.raster.TriangleForms                    SET_UP
            strategies.tiled.resolve.FaceCache                       SET_UP
            strategies.tiled.resolve.Face.fill                       SET_UP
            strategies.tiled.resolve.Face.edges                      SET_UP
            strategies.tiled.resolve.Face.findConstant               SET_UP
            strategies.tiled.resolve.Face.isUniform                  SET_UP
            strategies.tiled.resolve.Face.shadeConstant              SET_UP

            strategies.tiled.binning.BinFiller.enterLarge            COVER
            strategies.tiled.binning.CoarseRaster                    COVER
            strategies.tiled.binning.WideTriangles.enter             COVER
            strategies.tiled.binning.VectorSmallTriangleKernel       COVER
            strategies.tiled.binning.VectorSmallTriangleKernelKt     COVER
            strategies.tiled.binning.TriangleBins.lower              COVER
            strategies.tiled.binning.BandSpans                       COVER
            strategies.tiled.raster.FineRaster                       COVER
            strategies.tiled.TileRenderer                            COVER
            strategies.tiled.raster.BlockKernel                      COVER
            strategies.tiled.raster.ScalarBlockKernel                COVER
            strategies.tiled.raster.VectorBlockKernel                COVER
            strategies.tiled.raster.VectorBlockKernelKt              COVER
            strategies.tiled.raster.EdgeForms                        COVER
            strategies.tiled.raster.SmallCoverage                    COVER
            strategies.tiled.raster.TriangleForms.keyAt              COVER
            strategies.tiled.raster.TileGrid                         CALLER
            strategies.tiled.raster.VisibilityBuffer                 COVER
            raster.AreaBounds                                        COVER
            raster.EdgeTable                                         COVER
            raster.RowHull                                           COVER
            raster.TrapezoidCursor                                   COVER
            setup.LinePrimitive                                      COVER
            setup.LineStrokes                                        SET_UP
            setup.PointCloud                                         SET_UP
            setup.PointCloudKt                                       SET_UP
            setup.PointPrimitive                                     COVER
            setup.SampleRays                                         COVER
            setup.SpherePrimitive                                    COVER
            setup.SphereSetUp                                        SET_UP

            strategies.tiled.resolve.PrimitiveRuns                   RESOLVE
            strategies.tiled.resolve.TileShading                     RESOLVE
            strategies.tiled.resolve.FragmentKernel.runEnd           RESOLVE
            strategies.tiled.resolve.ScalarFragmentKernel.runEnd     RESOLVE
            strategies.tiled.resolve.VectorFragmentKernel.runEnd     RESOLVE

            setup.planar.PerspectiveWeights                          INTERPOLATE
            setup.planar.TextureFootprint                            INTERPOLATE
            setup.planar.PlanarPrimitive                             INTERPOLATE
            shading.AttributedPrimitive                              INTERPOLATE
            shading.Vertices                                         CALLER
            strategies.tiled.resolve.Face                            INTERPOLATE
            strategies.tiled.resolve.FragmentKernel                  INTERPOLATE
            strategies.tiled.resolve.ScalarFragmentKernel            INTERPOLATE
            strategies.tiled.resolve.VectorFragmentKernel            INTERPOLATE
            strategies.tiled.resolve.VectorFragmentKernelKt          INTERPOLATE
            strategies.tiled.resolve.ScatteredAttributes             INTERPOLATE
            strategies.tiled.resolve.TileShading.gather              INTERPOLATE
            strategies.tiled.resolve.TileShading.gatherSmall         INTERPOLATE
            strategies.tiled.resolve.WaitingFragments                INTERPOLATE

            shading.*                                                SHADE
            strategies.tiled.resolve.TileLayers                      SHADE
            strategies.tiled.resolve.TileShading.flush               SHADE
            strategies.tiled.resolve.TileShading.flushSmall          SHADE
            jmh.workload.RoundsShader                                SHADE

            Srgb                                                     ENCODE
            strategies.tiled.resolve.ScalarFragmentKernel.pack       ENCODE
            strategies.tiled.resolve.VectorFragmentKernel.pack       ENCODE
            strategies.tiled.resolve.VectorFragmentKernel.join       ENCODE
            strategies.tiled.resolve.VectorFragmentKernel.isOpaque   ENCODE
            strategies.tiled.resolve.VectorFragmentKernel$Component  ENCODE
            strategies.tiled.resolve.WaitingFragments.takeOut        ENCODE

            strategies.tiled.Rendering.runCallingThread              HAND_OUT
            jmh.stages.DroppedRows                                   HAND_OUT

            strategies.tiled.Kernels                                 OTHER
            strategies.tiled.Rendering                               OTHER
            strategies.tiled.Schedule                                OTHER
            strategies.tiled.Tiled                                   OTHER
            strategies.tiled.TiledMemory                             OTHER
            strategies.tiled.raster.CancellationCheck                OTHER
            pipeline.*                                               OTHER
            world.*                                                  OTHER
            geometry.*                                               CALLER
            *                                                        CALLER
            jmh.*                                                    OTHER
            """;

    private static final Map<String, String> STAGES = parse();

    private StageMap() {}

    /** What a rule says about a method. */
    enum Kind {
        /** The method belongs to a stage. */
        STAGE,

        /** The calling method decides. */
        CALLER,

        /** There is no rule. */
        NONE,
    }

    /**
     * What is known about a method.
     *
     * @param kind whether a stage is known
     * @param stage the stage, or null
     */
    record Found(Kind kind, Stage stage) {}

    /** Returns the names in the rules, without {@link #ROOT}. */
    static Set<String> names() {
        return STAGES.keySet();
    }

    /**
     * Returns the stage of a method.
     *
     * @param type binary name of its class, such as {@code dev.lazyz.Srgb}
     */
    static Found find(String type, String method) {
        if (!type.startsWith(ROOT)) {
            return new Found(Kind.NONE, null);
        }
        String name = type.substring(ROOT.length());
        String rule = ofMethod(name, method);
        if (rule == null) {
            rule = ofClass(name);
        }
        if (rule == null) {
            return new Found(Kind.NONE, null);
        }
        return rule.equals(CALLER) ? new Found(Kind.CALLER, null) : new Found(Kind.STAGE, Stage.valueOf(rule));
    }

    private static String ofMethod(String name, String method) {
        return STAGES.get(outer(name) + "." + method);
    }

    /** Returns the rule for a class, or for the package closest to it, or null. */
    private static String ofClass(String name) {
        if (STAGES.containsKey(name)) {
            return STAGES.get(name);
        }
        if (STAGES.containsKey(outer(name))) {
            return STAGES.get(outer(name));
        }
        int dot = name.lastIndexOf('.');
        for (; dot > 0; dot = name.lastIndexOf('.', dot - 1)) {
            String rule = STAGES.get(name.substring(0, dot) + ".*");
            if (rule != null) {
                return rule;
            }
        }
        // The root package is shared by all
        return name.indexOf('.') < 0 ? STAGES.get("*") : null;
    }

    /** Returns the name of the class that contains a nested class. */
    private static String outer(String name) {
        int at = name.indexOf('$');
        return at < 0 ? name : name.substring(0, at);
    }

    private static Map<String, String> parse() {
        Map<String, String> stages = new LinkedHashMap<>();
        for (String line : RULES.lines().filter(line -> !line.isBlank()).toList()) {
            String[] words = line.trim().split(" +");
            if (stages.put(words[0], words[1]) != null) {
                throw new IllegalStateException("two rules for " + words[0]);
            }
        }
        return stages;
    }
}
