package simgsm.ss;

import java.util.Arrays;
import java.util.Optional;

/** Reasons for rejecting a component (TS 24.080, 3.6.7). */
public enum SsProblem {
    UNRECOGNIZED_COMPONENT(Kind.GENERAL, 0, "unrecognized component"),
    MISTYPED_COMPONENT(Kind.GENERAL, 1, "mistyped component"),
    BADLY_STRUCTURED_COMPONENT(Kind.GENERAL, 2, "badly structured component"),
    DUPLICATE_INVOKE_ID(Kind.INVOKE, 0, "duplicate invoke identifier"),
    UNRECOGNIZED_OPERATION(Kind.INVOKE, 1, "unrecognized operation"),
    MISTYPED_PARAMETER(Kind.INVOKE, 2, "mistyped parameter"),
    RESOURCE_LIMITATION(Kind.INVOKE, 3, "resource limitation"),
    INITIATING_RELEASE(Kind.INVOKE, 4, "initiating release"),
    UNRECOGNIZED_LINKED_ID(Kind.INVOKE, 5, "unrecognized linked identifier"),
    LINKED_RESPONSE_UNEXPECTED(Kind.INVOKE, 6, "linked response unexpected"),
    UNEXPECTED_LINKED_OPERATION(Kind.INVOKE, 7, "unexpected linked operation"),
    RESULT_OF_UNKNOWN_INVOKE(Kind.RESULT, 0, "unrecognized invoke identifier"),
    RESULT_UNEXPECTED(Kind.RESULT, 1, "return result unexpected"),
    RESULT_MISTYPED(Kind.RESULT, 2, "mistyped parameter of the result"),
    ERROR_OF_UNKNOWN_INVOKE(Kind.ERROR, 0, "unrecognized invoke identifier of an error"),
    ERROR_UNEXPECTED(Kind.ERROR, 1, "return error unexpected"),
    ERROR_UNRECOGNIZED(Kind.ERROR, 2, "unrecognized error"),
    ERROR_NOT_EXPECTED_HERE(Kind.ERROR, 3, "unexpected error"),
    ERROR_MISTYPED(Kind.ERROR, 4, "mistyped parameter of the error");

    /** The part with the problem, by its BER tag. */
    enum Kind {
        GENERAL(0x80),
        INVOKE(0x81),
        RESULT(0x82),
        ERROR(0x83);

        final int tag;

        Kind(int tag) {
            this.tag = tag;
        }
    }

    private final Kind kind;
    private final int code;
    private final String title;

    SsProblem(Kind kind, int code, String title) {
        this.kind = kind;
        this.code = code;
        this.title = title;
    }

    int tag() {
        return kind.tag;
    }

    int code() {
        return code;
    }

    /** The problem's name in the standard. */
    public String title() {
        return title;
    }

    static Optional<SsProblem> of(int tag, int code) {
        return Arrays.stream(values())
                .filter(each -> each.kind.tag == tag && each.code == code)
                .findFirst();
    }
}
