@file:JvmName("PictureAssertions")

package dev.lazyz.conformance

import dev.lazyz.Image
import dev.lazyz.conformance.judgement.differenceInWords

/**
 * Fails unless [actual] is the same picture as [expected], as contract rule 7.1 has it: the same region, and at every
 * sample the same colour, depth and primitive, with no tolerance. Counters are not compared. Cost: one pass over the
 * samples.
 *
 * Kotlin: `assertSamePicture(expected, actual)`; Java: `PictureAssertions.assertSamePicture(expected, actual)`.
 *
 * @param code what makes the frame, for the message; nothing if it is empty
 * @throws AssertionError which names the first sample that differs, in rows from the top, with both answers, and how many
 *   samples differ; or both regions, if those differ
 */
@JvmOverloads
public fun assertSamePicture(expected: Image, actual: Image, code: String = "") {
    val words = differenceInWords(expected, actual) ?: return
    throw AssertionError("the pictures differ: $words" + if (code.isEmpty()) "" else "\nin\n$code")
}
