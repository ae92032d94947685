package simgsm.gateway.sip;

import java.util.List;
import java.util.function.Consumer;
import simgsm.gateway.sip.ClientTransactionTable.ClientTransactionAction;
import simgsm.gateway.sip.ClientTransactionTable.ClientTransactionEvent;
import simgsm.gateway.sip.ClientTransactionTable.ClientTransactionState;
import simgsm.state.StateMachine;
import simgsm.timer.Timer;

/** One request to a phone and its responses. */
final class ClientTransaction {
    private final SipMessage request;
    private final SipPeer peer;
    private final SipTransactions owner;
    private final Consumer<SipMessage> listener;
    private final StateMachine<ClientTransactionState, ClientTransactionEvent, ClientTransactionAction> machine;
    private SipMessage response;
    private long resendNanos = SipTransactions.T1_NANOS;
    private Timer resend;
    private Timer limit;

    /** @param listener receives the responses; 408 if none arrives within 32 s (8.1.3.1) */
    ClientTransaction(SipMessage request, SipPeer peer, SipTransactions owner, Consumer<SipMessage> listener) {
        this.request = request;
        this.peer = peer;
        this.owner = owner;
        this.listener = listener;
        machine = new StateMachine<>(ClientTransactionTable.TABLE, request.callId(), this::perform);
        List.of(ClientTransactionAction.SEND, ClientTransactionAction.START_RESEND, ClientTransactionAction.START_LIMIT)
                .forEach(this::perform);
    }

    SipMessage request() {
        return request;
    }

    private boolean isInvite() {
        return request.method().equals("INVITE");
    }

    boolean isProceeding() {
        return machine.state() == ClientTransactionState.PROCEEDING;
    }

    /** Sends CANCEL (9.1), with the branch of the request. Only after a provisional response. */
    void cancel() {
        machine.fire(ClientTransactionEvent.CANCEL);
        owner.request(derived("CANCEL", request.header("To").orElse("")), peer, ignored -> {});
    }

    void arrived(SipMessage answer) {
        response = answer;
        int status = answer.status();
        if (status >= 200 && !isInvite()) {
            machine.fire(ClientTransactionEvent.FINAL);
        } else if (isInvite()) {
            machine.fire(
                    status < 200
                            ? ClientTransactionEvent.RINGING
                            : status < 300 ? ClientTransactionEvent.ACCEPT : ClientTransactionEvent.REFUSE);
        }
    }

    private void perform(ClientTransactionAction action) {
        switch (action) {
            case SEND -> owner.transmit(request.encode(), peer);
            case SEND_ACK ->
                owner.transmit(derived("ACK", response.header("To").orElse("")).encode(), peer);
            case START_RESEND -> {
                resend = owner.timers().start(resendNanos, () -> machine.fire(ClientTransactionEvent.RESEND_EXPIRED));
                resendNanos = isInvite() ? 2 * resendNanos : Math.min(2 * resendNanos, SipTransactions.T2_NANOS);
            }
            case START_LIMIT ->
                limit = owner.timers()
                        .start(SipTransactions.LIMIT_NANOS, () -> machine.fire(ClientTransactionEvent.LIMIT_EXPIRED));
            case START_LINGER ->
                owner.timers()
                        .start(
                                isInvite() ? SipTransactions.LIMIT_NANOS : SipTransactions.T4_NANOS,
                                () -> machine.fire(ClientTransactionEvent.LINGER_EXPIRED));
            case STOP_TIMERS -> {
                owner.timers().cancel(resend);
                owner.timers().cancel(limit);
            }
            case REPORT -> listener.accept(response);
            case REPORT_TIMEOUT -> listener.accept(request.response(408, "Request Timeout"));
            case REMOVE -> owner.remove(this);
        }
    }

    /** The ACK of a refusal, or CANCEL (17.1.1.3, 9.1): same branch, From, Call-ID and number. */
    private SipMessage derived(String method, String to) {
        SipMessage derived = SipMessage.request(method, request.uri())
                .with("Via", request.header("Via").orElse(""))
                .with("Max-Forwards", "70")
                .with("From", request.header("From").orElse(""))
                .with("To", to)
                .with("Call-ID", request.callId())
                .with("CSeq", request.cseq() + " " + method);
        request.fields("Route").forEach(route -> derived.with("Route", route));
        return derived;
    }
}
