package dev.lazyz.conformance

import dev.lazyz.Frame
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Multitude
import dev.lazyz.conformance.cases.changed.HidingPlace
import dev.lazyz.conformance.cases.changed.alike
import dev.lazyz.conformance.cases.changed.backed
import dev.lazyz.conformance.cases.changed.behindMany
import dev.lazyz.conformance.cases.changed.behindMillions
import dev.lazyz.conformance.cases.changed.cutAtColumn
import dev.lazyz.conformance.cases.changed.cutAtRow
import dev.lazyz.conformance.cases.changed.dazzling
import dev.lazyz.conformance.cases.changed.flecked
import dev.lazyz.conformance.cases.changed.halfHeavyAndDark
import dev.lazyz.conformance.cases.changed.moved
import dev.lazyz.conformance.cases.changed.padded
import dev.lazyz.conformance.cases.changed.partlyColoured
import dev.lazyz.conformance.cases.changed.withHiddenGlass
import dev.lazyz.conformance.cases.veils as caseOfVeils
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.streamed as streamedAndWhole
import dev.lazyz.conformance.probes.surfacesOfOneShader as caseOfOneShader
import dev.lazyz.conformance.probes.textured as texturedCase
import dev.lazyz.conformance.probes.threads.Crowd
import dev.lazyz.conformance.probes.threads.KindOfWork
import dev.lazyz.conformance.probes.threads.Where
import dev.lazyz.conformance.probes.threads.WorkerProbe

/**
 * The frames of rules that a report names by a call, such as `SuiteFrames.textured(3659L)`, because their code would be
 * too long. Each call with the same arguments returns an equal frame, so that a program or a test can render the frame
 * of a report. Thread safe.
 */
public object SuiteFrames {
    /** An uneven sheet of small triangles, and some large ones, with textures. */
    @JvmStatic
    public fun textured(salt: Long): Frame = texturedCase(salt).frame

    /** Meshes and polygons with different attributes, whose materials have the same shader. */
    @JvmStatic
    public fun surfacesOfOneShader(salt: Long): Frame = caseOfOneShader(salt).frame

    /** Translucent layers of which the least change of a sum changes the picture. */
    @JvmStatic
    public fun veils(salt: Long): Frame = caseOfVeils(salt).frame

    /** Streamed meshes, some of them translucent if the renderer blends. */
    @JvmStatic
    public fun streamed(salt: Long, canBlend: Boolean): Frame = streamedAndWhole(salt, canBlend).first

    /** A primitive of more than 16,384 spans in a row. */
    @JvmStatic
    public fun manySpans(): Frame = Multitude.ofSpans().case.frame

    /** Hundreds of primitives, most of them in each column of a row. */
    @JvmStatic
    public fun longRow(): Frame = Multitude.ofRow().case.frame

    /** A million fragments of thin layers. */
    @JvmStatic
    public fun thinLayers(): Frame = Multitude.ofFragments().case.frame

    /** Tens of thousands of primitives at each sample, in the order of their depths or in the reverse order. */
    @JvmStatic
    public fun sorted(fromFar: Boolean, isTranslucent: Boolean): Frame =
        Multitude.ofSorted(fromFar, isTranslucent).case.frame

    /** Four primitives that cover all samples. */
    @JvmStatic
    public fun workers(): Frame = WorkerProbe.quiet().frame

    /** Four primitives that cover all samples, of which another one is the nearest at each. */
    @JvmStatic
    public fun crowd(salt: Long, where: String, kind: String): Frame =
        Crowd(salt, Where.valueOf(where), null, KindOfWork.valueOf(kind)).frame

    /** All primitives twice, as the same objects, and equal to each other. */
    @JvmStatic
    public fun alike(frame: Frame): Frame = of(frame).alike().frame

    /** With one more primitive, a unit of depth behind the picture. */
    @JvmStatic
    public fun backed(frame: Frame): Frame = of(frame).backed(ReferenceRenderer().render(frame)).frame

    /** With tens of thousands of primitives that cover nothing after half of the primitives. */
    @JvmStatic
    public fun behindMany(frame: Frame): Frame = of(frame).behindMany().frame

    /** With more than 2^24 primitives that cover nothing after half of the primitives. */
    @JvmStatic
    public fun behindMillions(frame: Frame): Frame = of(frame).behindMillions().frame

    /** With each primitive in two, cut before [column]. */
    @JvmStatic
    public fun cutAtColumn(frame: Frame, column: Int): Frame = of(frame).cutAtColumn(column).frame

    /** With each primitive in two, cut above [row]. */
    @JvmStatic
    public fun cutAtRow(frame: Frame, row: Int): Frame = of(frame).cutAtRow(row).frame

    /** With light without bounds, and alphas of mostly 0 and 1. */
    @JvmStatic
    public fun dazzling(frame: Frame): Frame = of(frame).dazzling().frame

    /** Each primitive of one colour with flecks of another, every other one without a shading cursor. */
    @JvmStatic
    public fun flecked(frame: Frame): Frame = of(frame).flecked().frame

    /** With every second primitive black, with alpha 0, and holding a megabyte. */
    @JvmStatic
    public fun halfHeavyAndDark(frame: Frame): Frame = of(frame).halfHeavyAndDark().frame

    /** With raster and primitives moved [right] columns to the right and [down] rows down. */
    @JvmStatic
    public fun moved(frame: Frame, right: Int, down: Int): Frame = of(frame).moved(right, down).frame

    /** With a primitive that covers nothing, but has the raster's bounds, before each primitive. */
    @JvmStatic
    public fun padded(frame: Frame): Frame = of(frame).padded().frame

    /** With shaders that set a colour at some samples only. */
    @JvmStatic
    public fun partlyColoured(frame: Frame): Frame = of(frame).partlyColoured().frame

    /** With a translucent primitive as number [index], which is invisible: it lies at this [place]. */
    @JvmStatic
    public fun withHiddenGlass(frame: Frame, index: Int, place: String): Frame =
        of(frame).withHiddenGlass(index, HidingPlace.valueOf(place)).frame

    private fun of(frame: Frame) = FrameCase(frame, "")
}
