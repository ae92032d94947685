package simgsm.modem.at;

/** Errors of the equipment (TS 27.007, 9.2). */
public enum CmeError {
    OPERATION_NOT_ALLOWED(3, "operation not allowed"),
    OPERATION_NOT_SUPPORTED(4, "operation not supported"),
    SIM_PIN_REQUIRED(11, "SIM PIN required"),
    SIM_PUK_REQUIRED(12, "SIM PUK required"),
    SIM_FAILURE(13, "SIM failure"),
    INCORRECT_PASSWORD(16, "incorrect password"),
    MEMORY_FULL(20, "memory full"),
    INVALID_INDEX(21, "invalid index"),
    NOT_FOUND(22, "not found"),
    TEXT_TOO_LONG(24, "text string too long"),
    INVALID_TEXT(25, "invalid characters in text string"),
    INVALID_DIAL_STRING(27, "invalid characters in dial string"),
    NO_NETWORK_SERVICE(30, "no network service"),
    NETWORK_TIMEOUT(31, "network timeout"),
    INCORRECT_PARAMETERS(50, "Incorrect parameters"),
    UNKNOWN(100, "unknown");

    private final int code;
    private final String words;

    CmeError(int code, String words) {
        this.code = code;
        this.words = words;
    }

    public int code() {
        return code;
    }

    /** In the verbose form. */
    public String words() {
        return words;
    }
}
