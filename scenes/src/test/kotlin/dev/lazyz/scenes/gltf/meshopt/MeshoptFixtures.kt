package dev.lazyz.scenes.gltf.meshopt

import java.util.Base64

/** What meshoptimizer 1.3.0 made of data that the tests compute again. */
internal object MeshoptFixtures {
    val version0Long = bytes(
        "oKqqqqoGZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZm" +
            "ZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZv////8AAgYKDhIWGh4iJiou" +
            "MjY6PkJGSk5SVlpeYmZqbnJ2en6ChoqOkpaanqKmqq6ytrq+wsbKztLW2t7i5uru8vb6/v359fHt6eXh3dnV0c3JxcG9ubWxraml" +
            "oZ2ZlZGNiYWBfXl1cW1pZWFdWVVRTUlFQT05NTEtKSUhHRkVEQ0JBQECBgoOEhYaHiImKi4yNjo+QkZKTlJWWl5iZmpucnZ6foKG" +
            "io6SlpqeoqaqrrK2ur7CxsrO0tba3uLm6u7y9vr+/fn18e3p5eHd2dXRzcnFwb25tbGtqaWhnZmVkY2JhYF9eXVxbWllYV1ZVVFN" +
            "SUVBPTk1MS0pJSEdGRURDQkFVVVVVQAgCAIAgCAIAgCAIAgCAIAgCAIAgCAIAgCAIAgCAIAgCAIAgCAIAgCAIAgCAIAgCAIAgCAI" +
            "AgCAIAgCAIAgCAIAAAAAKmZmZmZmZmZmZmZmZmZmZmZmZmZmZmYAAD8BAgYKDhIWGh4iJiouMjY6PkJGSk5SVlpeYmZqbnJ2en6C" +
            "hoqOkpaanqKmqgAAAAAVAIAgCAIAgCAIAgAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAH",
    )

    val version0 = bytes(
        "oCoGZmZmZmZmZmZmZmZmZmZmZmZmZgAAAAAfAAIGCg4SFhoeIiYqLjI2Oj5CRkpOUlZaXmJmam5ydnr//wAAfoKGio6SlpoVACAI" +
            "AgCAIAgCAAAAAB8AUFCfUFCfUFCfUFCfUFCfUFCfUFCfUFCfUFCfUFCfUP//AABQn1BQn1BQnx8AAg4mSnq2/q1NHpblVUbuXWLR" +
            "Buol1iHyEsF2RfVmMf//AAC9wk4ZdcX2vhUmZmZmZmZmZmZmAAAqDu7u7u7u7u7u7u7u7u7u7u7u7u4AAAAAKgZmZmZmZmZmZmZm" +
            "ZmZmZmZmZmZmAAAAAB8AAgYKDhIWGh4iJiouMjY6PkJGSk5SVlpeYmZqbnJ2ev//AAB+goaKjpKWmhUAIAgCAIAgCAIAAAAAHwBQ" +
            "UJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9Q//8AAFCfUFCfUFCfHwACDiZKerb+rU0eluVVRu5dYtEG6iXWIfISwXZF9WYx" +
            "//8AAL3CThl1xfa+FSZmZmZmZmZmZmYAAB8AHh4eHh4eHh4eHh4eHh4eHh4eHh4eHh4eHh4eHh4eHv//AAAeHh4eHh4eHgAAAAAA" +
            "AAAAAAAAAAAAAAAAAAAHAAAAAAAAAAcAAAAA",
    )

    val version1 = bytes(
        "oZ1fnd8qBmZmZmZmZmZmZmZmZmZmZmZmZmYAAAAAAAIGCg4SFhoeIiYqLjI2Oj5CRkpOUlZaXmJmam5ydnp+goaKjpKWmgUAIAgC" +
            "AIAgCAgAAgBQUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ8AAg4mSnq2/q1NHpblVUbuXWLRBuol1iHyEsF2" +
            "RfVmMb3CThl1xfa+FSZmZmZmZmZmZmYAACoO7u7u7u7u7u7u7u7u7u7u7u7u7gAAAAAqBmZmZmZmZmZmZmZmZmZmZmZmZmYAAAAA" +
            "AAIGCg4SFhoeIiYqLjI2Oj5CRkpOUlZaXmJmam5ydnp+goaKjpKWmgUAIAgCAIAgCAgAAgBQUJ9QUJ9QUJ9QUJ9QUJ9QUJ9QUJ9Q" +
            "UJ9QUJ9QUJ9QUJ9QUJ9QUJ8AAg4mSnq2/q1NHpblVUbuXWLRBuol1iHyEsF2RfVmMb3CThl1xfa+FSZmZmZmZmZmZmYAAAAeHh4e" +
            "Hh4eHh4eHh4eHh4eHh4eHh4eHh4eHh4eHh4eHh4eHh4eHh4AAAAAAAAABwAAAAAAAAAHAAAAAAAAAAA=",
    )

    val version1Channels = bytes(
        "oXWaeKoKqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqoERERERERERERERERERERERERERERERERERERERERERACZmZmZ" +
            "mZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZmZlVKqqqqqqqqqqqqqqqqqqq" +
            "qqoERERERERERERERERERERERERERERERERERERERERERAQwAAQMAPgYWDi42Jh4eJjYuHCwMPDgYEDAQMCQEBCw6EjIaGQEBBQ0" +
            "5CQM6qJiqvpSstpKwkKWrZlpvZXxkbWdiXmNhWkAMTE7BwMOBj9I/4814mEvPBESOh8TFyHwEwFwEw8cQxMEfwMHAAAAAAAAAAAA" +
            "AABg6gAAgD8AAMhCAQBC",
    )

    val triangles = bytes(
        "4f4eEA4QDhAOEA4QDv4eGw4aDhkOGA4XDv8eFw4XDhcOFw4XDv8eFw4XDhcOFw4XDv8eFw4XDhcOFw4XDv8eFw4XDhcOFw4XDv8f" +
            "/w8OvwJvCw5vCw5vCw5vCw7/aLkBB17/3KgHvakHAgB2h1ZneKmGZYlomAFpAAA=",
    )

    val indices = bytes("0QChHwQFBAW4ixGbHwAAAAA=")

    val octahedral8 = bytes(
        "oAMAPilPRwtAdmxoWTf/QwMhAwA0PAc3ZVc7UqZkVCUnuFEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAH9/",
    )

    val octahedral16 = bytes(
        "oAMAG6v4icUek7qiRHwTQz0OAgITUEhmM/MfDx4DALk3iXRjhjDdeEShb42d6wICQDVTamYT/xMaAAAAAAAAAAAAAAAAAAAAAAAA" +
            "AAAAAAAAAAAAAAAAAAD/B/9/",
    )

    val quaternions = bytes(
        "oAMAvYzinB33n3ceMWuBovi7AwDOHwbK9vHyDbn+c13GH5MDANT1Af0bUPbGNS/CCGyQRgMASImaMBv2ZwziS/UM8NbUAwDmmmyL" +
            "7/SLER0eE4PJ9m4DAFLo6r1aL3KfyfJwtBI7XAIBAhY0UkVhNgAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAACPXP9tAAD9fw==",
    )

    val exponents = bytes(
        "oAABAAAAP4D/4AMAFGMoKE9QAKAoAAkJBwUBAQQRqqoAAT/AAAAw33//AQL/AAAEEhiQAQQRqqoAAAAAAAAAAAAAAAAAAAAAAAAA" +
            "AAAAAAAAALDtABgA7Q==",
    )

    val colors8 = bytes(
        "of8AIiIihyIiJIkkIiKHIiIiAENDQ+9DQ0PvQ0ND70NDQwBDQ0NmQ0NBZEFDQ2ZDQ0MAfn1+fX59fn1+fX59fn1+AAAAAAAAAAAA" +
            "AAAAAAAAAAAAAH8Af8AA",
    )

    val colors16 = bytes(
        "oXdXACIiIociIiSJJCIihyIiIgEq6urqCAgIAENDQxBDQ0MQQ0NDEENDQwIERPRE9ET0RBEREQBDQ0NmQ0NBZEFDQ2ZDQ0MCAzNj" +
            "M2MzYzMBGZmZmQIGVlZWVlZWVgAAAAAAAAAAAAAAAAAA/wcAAP8HAAwBAA==",
    )

    fun bytes(base64: String): ByteArray = Base64.getDecoder().decode(base64)
}
