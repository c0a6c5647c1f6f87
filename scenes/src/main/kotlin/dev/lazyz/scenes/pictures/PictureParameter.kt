package dev.lazyz.scenes.pictures

/**
 * One of the [PictureParameters]: a property of [PictureSettings], an option of `zcli`, and a parameter of the other
 * [PictureDoor]s, under the same name and with the same values. Compared by identity.
 *
 * @property name lower case, with hyphens
 * @property group what it is about
 * @property values the values that it can have, and how words mean them
 * @property help a sentence about what it does, in which the names of others begin with `--`
 * @property default what happens without it, or null if that goes without saying
 * @property missing the doors that do not have it, each with the reason
 */
public class PictureParameter<T : Any> internal constructor(
    public val name: String,
    public val group: ParameterGroup,
    public val values: ParameterValues<T>,
    public val help: String,
    public val default: String?,
    public val missing: Map<PictureDoor, String>,
) {
    /**
     * Returns [help] and the default, with [prefix] before names of parameters.
     *
     * @param default what to say of the default
     */
    @JvmOverloads
    public fun text(prefix: String = "--", default: String? = this.default): String =
        (help + default?.let { "; default: $it" }.orEmpty()).replace("--", prefix)

    override fun toString(): String = name
}

/** What parameters are about: the sections of `zcli render --help`. */
public enum class ParameterGroup(public val title: String) {
    READING("Reading"),
    PICTURE("Picture"),
    LIGHT("Light"),
    CAMERA("Camera"),
    LINES("Lines and sections"),
    PAPER("Drawings on paper"),
    ;

    /** The parameters of this group, in the order of the table. */
    public val parameters: List<PictureParameter<*>> get() = PictureParameters.all.filter { it.group == this }
}

/** Where users can ask for a picture with words. */
public enum class PictureDoor {
    /** The options of `zcli render`. */
    COMMAND_LINE,

    /** The query of the render service. Its files are names in an archive, see `ModelArchive.read`. */
    SERVICE,

    /** The words `name=value` of `ModelPictures` for Apache Spark. Its files are names in an archive, too. */
    SPARK,

    /** The object `picture` of a scene file. */
    SCENE_FILE,
    ;

    /** The parameters that this door has, in the order of the table. */
    public val parameters: List<PictureParameter<*>> get() = PictureParameters.all.filter { this !in it.missing }

    /**
     * Returns [settings] with the parameters that [words] describe, each a name and a value. If a name is repeated, the
     * last value counts; planes that cut add up.
     *
     * @throws IllegalArgumentException if a name or a value is unknown; the message is for the user
     */
    public fun read(settings: PictureSettings, words: Iterable<Pair<String, String>>): PictureSettings {
        val known = parameters.associateBy { it.name }
        return words.fold(settings) { before, (name, word) ->
            val parameter = requireNotNull(known[name]) {
                "there is no parameter '$name'; there are ${known.keys.joinToString()}"
            }
            before.withWord(parameter, word)
        }
    }
}

/**
 * How messages name parameters: `eye` and `eye=1,2,3`, or in another form.
 *
 * @param prefix comes before each name
 * @param separator comes between a name and a value
 */
public class ParameterNames(private val prefix: String, private val separator: String) {
    /** Returns how a user writes the name of [parameter]. */
    public fun of(parameter: PictureParameter<*>): String = of(parameter.name)

    /** Returns how a user writes [parameter] with a value. */
    public fun of(parameter: PictureParameter<*>, value: Any): String = of(parameter) + separator + value

    internal fun of(name: String): String = prefix + name

    override fun toString(): String = "ParameterNames($prefix, $separator)"
}
