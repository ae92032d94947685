package vericommand;

/** The keys that fit at the position of a fault. */
public enum ExpectedKeys {
    OPENING("**"),
    STAR("*"),
    HASH("#"),
    STAR_OR_HASH("* / #"),
    STAR_HASH_OR_DIGIT(null),
    /** A number, or a number within its range. */
    NUMBER(null),
    DIGIT_HASH_OR_STAR(null),
    DIGIT_OR_CLOSING(null),
    HASH_OR_STAR("# / *"),
    CLOSING("**"),
    /** Nothing more: a short message holds one order. */
    END(null);

    private final String keys;

    ExpectedKeys(String keys) {
        this.keys = keys;
    }

    /** The keys where they need no translation, else null. */
    String keys() {
        return keys;
    }
}
