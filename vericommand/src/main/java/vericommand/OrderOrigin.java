package vericommand;

/** Where an order comes from and its reply goes to: one call or one short message. */
final class OrderOrigin {
    private final String number;
    private final boolean message;
    private boolean ended;

    private OrderOrigin(String number, boolean message) {
        this.number = number;
        this.message = message;
    }

    static OrderOrigin call(String number) {
        return new OrderOrigin(number, false);
    }

    static OrderOrigin message(String number) {
        return new OrderOrigin(number, true);
    }

    String number() {
        return number;
    }

    boolean isMessage() {
        return message;
    }

    /** The call is over: its orders get no further reply. */
    void end() {
        ended = true;
    }

    boolean isEnded() {
        return ended;
    }
}
