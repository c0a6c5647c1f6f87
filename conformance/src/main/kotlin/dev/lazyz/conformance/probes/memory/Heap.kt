package dev.lazyz.conformance.probes.memory

import dev.lazyz.conformance.judgement.notMeasured
import java.lang.ref.Reference
import java.lang.ref.WeakReference
import kotlin.math.abs

/** What the heap holds: what is left when the garbage has been collected. */
internal object Heap {
    private const val ATTEMPTS = 5
    private const val BLOCK = 1024
    private const val HEADER = 16

    /** As many times the limit are no noise, such as a block of rows that is not garbage yet. */
    private const val CLEAR = 8

    /** A quarter of the least that a rule forgives. */
    private const val TOLERANCE = 32 * BLOCK

    /** Bytes whose measurement is tried: collectors that count in regions get some of them right by chance, not all. */
    private val KNOWN = listOf(128 * BLOCK, 512 * BLOCK, 1024 * BLOCK)

    @Volatile
    private var isKnownToBeExact = false

    /** Ends the rule where the garbage collector has been told not to work when it is asked to. */
    fun requireCollection() {
        val garbage = WeakReference(ByteArray(1))
        if (!isSoon { garbage.get() == null }) notMeasured("this JVM ignores System.gc()")
    }

    /** Ends the rule where that is so, or where bytes that are known to be held are not what is measured. */
    private fun requireMeasurable() {
        requireCollection()
        if (!isExact()) notMeasured("this JVM's garbage collector counts memory in large regions, not in objects")
    }

    /** Whether the heap grows by what is allocated. ZGC and Shenandoah count regions of some megabytes. */
    fun isExact(): Boolean {
        if (!isKnownToBeExact) isKnownToBeExact = KNOWN.all { isExact(it) }
        return isKnownToBeExact
    }

    private fun isExact(bytes: Int): Boolean {
        repeat(ATTEMPTS) {
            val held = most { measure ->
                val blocks = List(bytes / BLOCK) { ByteArray(BLOCK - HEADER) }
                measure()
                Reference.reachabilityFence(blocks)
            }
            if (abs(held - bytes) <= TOLERANCE) return true
        }
        return false
    }

    /** Whether [isSo] becomes true after some collections. */
    fun isSoon(isSo: () -> Boolean): Boolean {
        repeat(2 * ATTEMPTS) {
            System.gc()
            if (isSo()) return true

            // Threads that have just ended may take a moment to let go of what they held
            Thread.sleep(it.toLong())
        }
        return false
    }

    /** Returns the most bytes that are held, beyond those from before, when [work] calls the function it is given. */
    fun most(work: (measure: () -> Unit) -> Unit): Long {
        val before = settled()
        var most = 0L
        work { synchronized(this) { most = maxOf(most, held() - before) } }
        return most
    }

    /**
     * Calls [fail] with the least of several [measurements] unless one of them is at most [limit]: noise only adds. Of what is
     * clearly too much two are enough.
     */
    fun requireAtMost(limit: Long, measurements: () -> Long, fail: (least: Long) -> Nothing) {
        requireMeasurable()
        var least = Long.MAX_VALUE
        repeat(ATTEMPTS) { attempt ->
            least = minOf(least, measurements())
            if (least <= limit) return
            if (attempt > 0 && least > CLEAR * limit) fail(least)
        }
        fail(least)
    }

    /** Returns the smaller of two [measurements]: for what others are compared with, which noise must not make larger. */
    fun less(measurements: () -> Long): Long = minOf(measurements(), measurements())

    /** The bytes that are held as soon as they do not become fewer. */
    private fun settled(): Long {
        var least = held()
        repeat(ATTEMPTS) {
            Thread.sleep(1)
            val now = held()
            if (now >= least) return least
            least = now
        }
        return least
    }

    private fun held(): Long {
        System.gc()
        val runtime = Runtime.getRuntime()
        return runtime.totalMemory() - runtime.freeMemory()
    }
}
