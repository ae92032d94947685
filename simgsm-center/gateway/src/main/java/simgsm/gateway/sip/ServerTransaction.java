package simgsm.gateway.sip;

import simgsm.gateway.sip.ServerTransactionTable.ServerTransactionAction;
import simgsm.gateway.sip.ServerTransactionTable.ServerTransactionEvent;
import simgsm.gateway.sip.ServerTransactionTable.ServerTransactionState;
import simgsm.state.StateMachine;
import simgsm.timer.Timer;

/** One request of a phone and its responses. */
final class ServerTransaction {
    private final SipMessage request;
    private final SipPeer peer;
    private final SipTransactions owner;
    private final StateMachine<ServerTransactionState, ServerTransactionEvent, ServerTransactionAction> machine;
    /** Tag that this side adds to To; one for all responses. */
    private final String tag;

    private byte[] response;
    private long resendNanos = SipTransactions.T1_NANOS;
    private Timer resend;
    private Timer limit;
    private Runnable unacknowledged = () -> {};

    ServerTransaction(SipMessage request, SipPeer peer, SipTransactions owner) {
        this.request = request;
        this.peer = peer;
        this.owner = owner;
        tag = request.address("To").tag().isEmpty()
                ? owner.randomWord()
                : request.address("To").tag();
        machine = new StateMachine<>(ServerTransactionTable.TABLE, request.callId(), this::perform);
    }

    SipMessage request() {
        return request;
    }

    /** The source of the request, and the address of its responses. */
    SipPeer peer() {
        return peer;
    }

    String tag() {
        return tag;
    }

    boolean isInvite() {
        return request.method().equals("INVITE");
    }

    /** True until a final response. */
    boolean isOpen() {
        return machine.state() == ServerTransactionState.TRYING || machine.state() == ServerTransactionState.PROCEEDING;
    }

    /** A response to be completed and passed to {@link #send}. */
    SipMessage response(int status, String reason) {
        SipMessage answer = request.response(status, reason);
        if (status > 100 && request.address("To").tag().isEmpty()) {
            answer.replace("To", request.header("To").orElse("") + ";tag=" + tag);
        }
        return answer;
    }

    void respond(int status, String reason) {
        send(response(status, reason));
    }

    /** Sends a response; a final one is repeated as its method demands. */
    void send(SipMessage answer) {
        byte[] before = response;
        response = answer.encode();
        int status = answer.status();
        ServerTransactionEvent event = status < 200
                ? ServerTransactionEvent.PROVISIONAL
                : !isInvite()
                        ? ServerTransactionEvent.FINAL
                        : status < 300 ? ServerTransactionEvent.ACCEPT : ServerTransactionEvent.REFUSE;
        if (!machine.fire(event)) {
            response = before;
        }
    }

    /** Sets what runs if no ACK arrives for a 200 to INVITE within 32 s. */
    void onUnacknowledged(Runnable action) {
        unacknowledged = action;
    }

    void repeated() {
        machine.fire(ServerTransactionEvent.REPEATED);
    }

    void acknowledged() {
        machine.fire(ServerTransactionEvent.ACK);
    }

    private void perform(ServerTransactionAction action) {
        switch (action) {
            case SEND -> owner.transmit(response, peer);
            case START_G -> {
                resend = owner.timers().start(resendNanos, () -> machine.fire(ServerTransactionEvent.G_EXPIRED));
                resendNanos = Math.min(2 * resendNanos, SipTransactions.T2_NANOS);
            }
            case START_H ->
                limit = owner.timers()
                        .start(SipTransactions.LIMIT_NANOS, () -> machine.fire(ServerTransactionEvent.H_EXPIRED));
            case START_LINGER ->
                owner.timers()
                        .start(
                                isInvite() ? SipTransactions.T4_NANOS : SipTransactions.LIMIT_NANOS,
                                () -> machine.fire(ServerTransactionEvent.LINGER_EXPIRED));
            case STOP_TIMERS -> {
                owner.timers().cancel(resend);
                owner.timers().cancel(limit);
            }
            case REPORT_UNACKNOWLEDGED -> unacknowledged.run();
            case REMOVE -> owner.remove(this);
        }
    }
}
