package simgsm.gateway.sip;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** The dialog of a call (RFC 3261, 12): what the requests of both sides have in common. */
final class SipDialog {
    private final SipContext context;
    private final String callId;
    private final String localTag;
    private final String local;
    private String remote;
    private String target;
    private SipPeer peer;
    private List<String> routes = List.of();
    private long localCseq;
    private long remoteCseq = -1;
    /** Requests up to this one have been held back once, see {@link #isAwaited}. */
    private long heldBackCseq = -1;

    /** A dialog that a phone's INVITE creates. */
    SipDialog(SipContext context, ServerTransaction invite) {
        this.context = context;
        SipMessage request = invite.request();
        callId = request.callId();
        localTag = invite.tag();
        local = invite.response(200, "").header("To").orElse("");
        remote = request.header("From").orElse("");
        remoteCseq = request.cseq();
        routes = request.values("Record-Route");
        peer = invite.peer();
        retarget(request, peer);
    }

    /** A dialog that an INVITE to a phone creates. @param target its Contact */
    SipDialog(SipContext context, String caller, String number, String target, SipPeer peer) {
        this.context = context;
        this.target = target;
        this.peer = peer;
        callId = context.transactions().randomWord() + "@simgsm";
        localTag = context.transactions().randomWord();
        local = "<" + context.uri(caller, peer) + ">;tag=" + localTag;
        remote = "<" + context.uri(number, peer) + ">";
    }

    /** True if a request of the phone, or an ACK, belongs to the dialog. */
    boolean has(SipMessage request) {
        return request.callId().equals(callId)
                && request.address("To").tag().equals(localTag)
                && request.address("From").tag().equals(SipValue.parse(remote).tag());
    }

    SipPeer peer() {
        return peer;
    }

    /** The phone's Contact of an INVITE or its 200, and the address that it came from. */
    void retarget(SipMessage message, SipPeer from) {
        message.values("Contact").stream()
                .findFirst()
                .ifPresent(it -> target = SipValue.parse(it).main());
        target = target == null ? SipValue.parse(remote).main() : target;
        peer = from;
    }

    /** The phone's 200 to INVITE: its tag, Contact and route. */
    void established(SipMessage answer) {
        remote = answer.header("To").orElse(remote);
        routes = new ArrayList<>(answer.values("Record-Route"));
        Collections.reverse(routes);
        retarget(answer, peer);
    }

    /** Takes the number of a phone's request; false if it is out of order (12.2.2). */
    boolean isInOrder(SipMessage request) {
        boolean isNew = request.cseq() > remoteCseq;
        remoteCseq = Math.max(remoteCseq, request.cseq());
        return isNew;
    }

    /**
     * True if an earlier request seems to be on its way: a number is missing before this one, which has not been held
     * back yet. Keys by INFO would otherwise change their order when one is lost.
     */
    boolean isAwaited(SipMessage request) {
        boolean isEarly = request.cseq() > remoteCseq + 1 && request.cseq() > heldBackCseq;
        heldBackCseq = isEarly ? request.cseq() : heldBackCseq;
        return isEarly;
    }

    String contact(String number) {
        return "<" + context.uri(number, peer) + ">";
    }

    /** The next request of this side. */
    SipMessage request(String method) {
        return request(method, ++localCseq);
    }

    /** ACK of a 200 to INVITE has its number and a branch of its own. */
    SipMessage ack(SipMessage answer) {
        return request("ACK", answer.cseq());
    }

    private SipMessage request(String method, long cseq) {
        SipMessage request = context.request(method, target, peer, local, remote, callId, cseq);
        routes.forEach(route -> request.with("Route", route));
        return request;
    }
}
