package dev.lazyz.conformance.results

import dev.lazyz.conformance.rules.AllRules
import dev.lazyz.conformance.rules.FIXED
import dev.lazyz.conformance.rules.Level
import dev.lazyz.conformance.rules.Rule
import dev.lazyz.conformance.rules.Symptom
import java.io.IOException
import java.lang.reflect.Method
import java.nio.charset.CharacterCodingException
import java.nio.file.AccessDeniedException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.NoSuchFileException
import java.nio.file.NotDirectoryException

/**
 * A rule of the suite, for use in reports. Immutable and thread safe.
 *
 * @property name the method's name, such as `rule_5_2_tiesGoToTheFirstSubmitted`: unique, and used in waivers
 * @property level how binding the rule is
 * @property intent why the rule exists, in one sentence
 * @property look where to look in the renderer when the rule fails, in one sentence
 */
public class SuiteRule private constructor(
    public val name: String,
    private val rule: Rule,
    private val ownMethod: Method?,
) {
    private constructor(method: Method) : this(method.name, method.getAnnotation(Rule::class.java), method)

    /** A rule that has no method, because its frames are scenes of the corpus. */
    internal constructor(name: String, rule: Rule) : this(name, rule, null)

    /** The method of a rule for renderers. */
    internal val method: Method get() = checkNotNull(ownMethod) { "$name is a rule of the corpus" }

    public val level: Level get() = rule.level

    public val intent: String get() = rule.intent

    public val look: String get() = rule.look

    /** Symptoms of the mistakes that the rule tests for, see [Rule.about]. */
    internal val about: Set<Symptom> get() = rule.about.toSet()

    /** How often it is tried by default. */
    internal val tries: Int get() = if (ownMethod?.parameterCount == 0) 1 else rule.tries

    /** Whether other rules are named before it, see [Rule.isSpecial]. */
    internal val isSpecial: Boolean get() = rule.isSpecial

    /** The rule's number in `docs/contract.md`, such as `5.2`. Several tests may have the same number. */
    public val number: String get() = numbers().joinToString(".")

    /**
     * Returns the seed of this rule's frames for the [suite]'s seed: a 64-bit FNV-1a hash over the characters of
     * [name], with [suite] as its initial value. So each rule has its own frames, which do not depend on the other
     * rules.
     */
    internal fun seed(suite: Long): Long = name.fold(suite) { hash, char -> (hash xor char.code.toLong()) * FNV_PRIME }

    private fun numbers(): List<Int> =
        name.removePrefix(PREFIX).split('_').takeWhile { it.toIntOrNull() != null }.map { it.toInt() }

    override fun toString(): String = name

    public companion object {
        private const val PREFIX = "rule_"
        private const val FNV_PRIME = 0x100000001B3L

        /** All rules of the suite, ordered by number and then by name. */
        @JvmStatic
        public val all: List<SuiteRule> = AllRules::class.java.methods
            .filter { it.isAnnotationPresent(Rule::class.java) }
            .map { SuiteRule(it) }
            .sortedWith(compareBy({ it.numbers().first() }, { it.numbers().getOrElse(1) { 0 } }, { it.name }))

        /** Returns the rule called [name], or null if there is none. */
        @JvmStatic
        public fun find(name: String): SuiteRule? = all.firstOrNull { it.name == name }

        /** Returns the rule with that name, or all rules with that number (`5.2`); empty if there is none. */
        @JvmStatic
        public fun matching(nameOrNumber: String): List<SuiteRule> =
            all.filter { it.name == nameOrNumber || it.number == nameOrNumber }

        /** The suite's default seed. */
        internal val fixedSeed: Long = FIXED.toLong()
    }
}

/** Returns [number] and what it counts, [thing], in the plural unless the number is 1. */
internal fun counted(number: Long, thing: String): String = if (number == 1L) "1 $thing" else "$number ${thing}s"

/** Returns why a file or a folder cannot be used, for a message that names it. */
internal fun reason(failure: IOException): String = when (failure) {
    is NoSuchFileException -> "there is no such file"
    is AccessDeniedException -> "permission denied"
    is NotDirectoryException, is FileAlreadyExistsException -> "it is not a folder"
    is CharacterCodingException -> "it is not text in UTF-8"
    is FileSystemException -> failure.reason ?: failure.javaClass.simpleName
    else -> failure.message ?: failure.javaClass.simpleName
}
