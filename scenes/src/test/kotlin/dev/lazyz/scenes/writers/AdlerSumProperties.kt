package dev.lazyz.scenes.writers

import java.nio.ByteBuffer
import java.util.zip.Adler32
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.constraints.IntRange
import org.junit.jupiter.api.Assertions.assertEquals

class AdlerSumProperties {
    @Property(seed = "1995", tries = 200)
    fun sumOfPartsIsTheSumOfTheWhole(@ForAll parts: List<ByteArray>) {
        val whole = Adler32()
        val sum = AdlerSum()
        for (part in parts) {
            whole.update(part)
            sum.add(adler(part), part.size)
        }
        assertEquals(whole.value.toInt(), ByteBuffer.wrap(sum.toBytes()).getInt())
    }

    @Property(seed = "1995", tries = 20)
    fun longPartsDoNotOverflow(@ForAll @IntRange(min = 1, max = 5) count: Int) {
        val part = ByteArray(1_000_003) { -1 }
        val whole = Adler32()
        val sum = AdlerSum()
        repeat(count) {
            whole.update(part)
            sum.add(adler(part), part.size)
        }
        assertEquals(whole.value.toInt(), ByteBuffer.wrap(sum.toBytes()).getInt())
    }

    private fun adler(bytes: ByteArray): Int = Adler32().apply { update(bytes) }.value.toInt()
}
