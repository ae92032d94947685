package simrobot.replay;

/** What a checked record holds makes no sense; says what. */
final class DamagedException extends RuntimeException {
    DamagedException(String message) {
        super(message);
    }
}
