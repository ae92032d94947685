package vericommand;

/** Who gave an order and how the answer goes back: one call, or one short message. */
final class OrderOrigin {
    private final String number;
    private final boolean message;
    private boolean gone;

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

    /** The call is over: nothing that it ordered is answered any more. */
    void leave() {
        gone = true;
    }

    boolean isGone() {
        return gone;
    }
}
