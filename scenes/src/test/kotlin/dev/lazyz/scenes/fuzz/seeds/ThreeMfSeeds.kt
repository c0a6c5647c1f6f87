package dev.lazyz.scenes.fuzz.seeds

import dev.lazyz.scenes.fuzz.Companions
import dev.lazyz.scenes.fuzz.mutations.ZipFiles

/** Packages in 3MF: a plain tetrahedron, and one of several parts with components, colours and a texture. */
internal object ThreeMfSeeds {
    private const val TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
    private const val NAMESPACES = "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" " +
        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" " +
        "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\""
    private const val VERTICES = "<vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>" +
        "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices>"

    private fun mesh(looks: List<String>) = listOf("0,2,1", "0,1,3", "0,3,2", "1,2,3").zip(looks).joinToString(
        "",
        "<mesh>$VERTICES<triangles>",
        "</triangles></mesh>",
    ) { (corners, look) ->
        val (a, b, c) = corners.split(',')
        "<triangle v1=\"$a\" v2=\"$b\" v3=\"$c\" $look/>"
    }

    private fun model(resources: String, build: String) = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
        "<model unit=\"millimeter\" xml:lang=\"en-US\" $NAMESPACES><metadata name=\"Title\">a</metadata>" +
        "<resources>$resources</resources><build>$build</build></model>"

    private val plain =
        model("<object id=\"1\" type=\"model\">${mesh(List(4) { "" })}</object>", "<item objectid=\"1\"/>")

    private val looks = "<basematerials id=\"5\"><base name=\"a\" displaycolor=\"#FF8000\"/>" +
        "<base name=\"b\" displaycolor=\"#FF800080\"/></basematerials>" +
        "<m:colorgroup id=\"6\"><m:color color=\"#00FF00\"/><m:color color=\"#0000FF\"/></m:colorgroup>" +
        "<m:texture2d id=\"7\" path=\"/3D/t.png\" contenttype=\"image/png\" " +
        "tilestyleu=\"mirror\" tilestylev=\"clamp\"/>" +
        "<m:texture2dgroup id=\"8\" texid=\"7\"><m:tex2coord u=\"0\" v=\"0\"/><m:tex2coord u=\"1\" v=\"0\"/>" +
        "<m:tex2coord u=\"0\" v=\"1\"/></m:texture2dgroup>" +
        "<m:compositematerials id=\"9\" matid=\"5\" matindices=\"0 1\"><m:composite values=\"0.5 0.5\"/>" +
        "</m:compositematerials><m:multiproperties id=\"10\" pids=\"5 6\"><m:multi pindices=\"0 1\"/></m:multiproperties>"

    private val pictured = listOf(
        "pid=\"6\" p1=\"0\" p2=\"1\" p3=\"0\"",
        "pid=\"8\" p1=\"0\" p2=\"1\" p3=\"2\"",
        "pid=\"9\" p1=\"0\"",
        "",
    )

    private val rich = model(
        looks + "<object id=\"1\" pid=\"5\" pindex=\"0\" name=\"a\">" +
            mesh(pictured) +
            "</object><object id=\"2\" type=\"model\"><components><component objectid=\"1\" " +
            "transform=\"1 0 0 0 1 0 0 0 1 5 6 7\"/>" +
            "<component objectid=\"3\" p:path=\"/3D/other.model\"/></components>" +
            "</object><object id=\"4\" type=\"support\">${mesh(List(4) { "pid=\"10\" p1=\"0\"" })}</object>",
        "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 0\"/><item objectid=\"4\"/>",
    )

    private val other = model("<object id=\"3\" type=\"other\">${mesh(List(4) { "" })}</object>", "")

    private fun archive(model: String, more: List<Pair<String, ByteArray>>) = ZipFiles.of(
        listOf(
            "[Content_Types].xml" to "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">" +
                "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>",
            "_rels/.rels" to "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">" +
                "<Relationship Target=\"/3D/3dmodel.model\" Id=\"a\" Type=\"$TYPE\"/></Relationships>",
            "3D/3dmodel.model" to model,
        ).map { (name, text) -> name to text.toByteArray() } + more,
    )

    val all: List<ByteArray> = listOf(
        archive(plain, emptyList()),
        archive(rich, listOf("3D/other.model" to other.toByteArray(), "3D/t.png" to Companions.png)),
    )
}
