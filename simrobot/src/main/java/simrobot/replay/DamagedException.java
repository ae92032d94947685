package simrobot.replay;

/** What a checked record holds makes no sense; says what. */
public final class DamagedException extends RuntimeException {
    DamagedException(String message) {
        super(message);
    }
}
