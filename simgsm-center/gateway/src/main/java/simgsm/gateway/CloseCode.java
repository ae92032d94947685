package simgsm.gateway;

/** Close codes of the socket {@code /phone}. */
final class CloseCode {
    /** RFC 6455, 7.4.1: the message is not the expected one. */
    static final int POLICY_VIOLATION = 1008;

    /** RFC 6455, 7.4.1: the program ends. */
    static final int GOING_AWAY = 1001;

    /** The IANA's registry of close codes: too many wrong keys. */
    static final int TRY_AGAIN_LATER = 1013;

    static final int OPENED_ELSEWHERE = 4000;
    static final int WRONG_KEY = 4001;
    static final int NO_NUMBER = 4002;
    static final int LOCKED = 4003;
    static final int DROPPED = 4004;

    private CloseCode() {}
}
