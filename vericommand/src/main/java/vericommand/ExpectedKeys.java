package vericommand;

/** What a recogniser expected at the place where an order breaks off. */
public enum ExpectedKeys {
    OPENING("**"),
    STAR("*"),
    HASH("#"),
    STAR_OR_HASH("* / #"),
    STAR_HASH_OR_ZERO("* / # / 0"),
    /** A number, or one within its range. */
    NUMBER(null),
    DIGIT_HASH_OR_STAR(null),
    HASH_OR_STAR("# / *"),
    CLOSING("**"),
    /** Nothing more: a short message holds one order. */
    END(null);

    private final String keys;

    ExpectedKeys(String keys) {
        this.keys = keys;
    }

    /** The keys themselves where they need no translation, else null. */
    String keys() {
        return keys;
    }
}
