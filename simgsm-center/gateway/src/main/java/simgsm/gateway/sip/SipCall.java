package simgsm.gateway.sip;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.gateway.sip.SipCallTable.SipCallAction;
import simgsm.gateway.sip.SipCallTable.SipCallEvent;
import simgsm.gateway.sip.SipCallTable.SipCallState;
import simgsm.state.StateMachine;
import simgsm.station.MobileStation;
import simgsm.timer.Timer;

/** One call of a SIP user, run by {@link SipCallTable}: a dialog with the phone, and the station's call. */
final class SipCall {
    private static final String SDP = "application/sdp";
    /** A phone without speech, as with silence suppression, is asked for a sign. */
    private static final long QUIET_NANOS = TimeUnit.SECONDS.toNanos(3);
    /** A phone without a sign has gone; its robot stops. */
    private static final long LOST_NANOS = TimeUnit.SECONDS.toNanos(10);

    private final SipContext context;
    private final MobileStation station;
    private final String number;
    private final SipSpeech speech;
    private final StateMachine<SipCallState, SipCallEvent, SipCallAction> machine;
    private SipDialog dialog;
    /** The phone's newest INVITE; null without one. */
    private ServerTransaction invite;
    /** The INVITE to the phone; null without one. */
    private ClientTransaction outgoing;

    private SipMessage answer;
    private Optional<Sdp> description = Optional.empty();
    private int versions;
    private Msisdn called;
    private Cause cause = Cause.NORMAL_CALL_CLEARING;
    private boolean isCancelDue;
    private long signNanos;
    private Timer watch;

    SipCall(SipContext context, MobileStation station, SipSpeech speech) {
        this.context = context;
        this.station = station;
        this.speech = speech;
        number = station.identity().number().digits();
        machine = new StateMachine<>(SipCallTable.TABLE, number, this::perform);
    }

    /** True from the first message of the call to the last. */
    boolean isUnderWay() {
        return machine.state() != SipCallState.IDLE && machine.state() != SipCallState.ENDED;
    }

    boolean has(SipMessage message) {
        return dialog != null && dialog.has(message);
    }

    /** True if this is the INVITE that has begun the call or renews its description. */
    boolean isOf(ServerTransaction transaction) {
        return invite == transaction;
    }

    /** A phone's INVITE without a dialog. */
    void invited(ServerTransaction request, Msisdn to) {
        invite = request;
        called = to;
        dialog = new SipDialog(context, request);
        if (request.request().body().length > 0 && !takeDescription(request.request())) {
            request.respond(488, "Not Acceptable Here: expected PCMA or PCMU over RTP/AVP");
        } else if (!openSpeech()) {
            request.respond(503, "Service Unavailable: no UDP port is free");
        } else {
            request.respond(100, "Trying");
            machine.fire(SipCallEvent.INVITED);
        }
    }

    /** The network offers a call. @param contact of the phone; @param peer where it has registered */
    void offered(Optional<Msisdn> caller, String contact, SipPeer peer) {
        dialog = new SipDialog(context, caller.map(Msisdn::toString).orElse("anonymous"), number, contact, peer);
        if (openSpeech()) {
            machine.fire(SipCallEvent.OFFERED);
        } else {
            station.clear(Cause.RESOURCES_UNAVAILABLE);
        }
    }

    private boolean openSpeech() {
        SipTransport.Media media = context.transport().openMedia(speech::arrived);
        if (media != null) {
            speech.use(media);
        }
        return media != null;
    }

    void alerted() {
        machine.fire(SipCallEvent.ALERTED);
    }

    void connected() {
        machine.fire(SipCallEvent.CONNECTED);
    }

    void released(Cause byNetwork) {
        cause = byNetwork;
        machine.fire(SipCallEvent.RELEASED);
    }

    /** The user has gone. */
    void lost() {
        cause = Cause.NORMAL_CALL_CLEARING;
        machine.fire(SipCallEvent.PHONE_LOST);
    }

    /** CANCEL, already answered. */
    void cancelled() {
        cause = Cause.NORMAL_CALL_CLEARING;
        machine.fire(SipCallEvent.PHONE_CANCELLED);
    }

    void acknowledged(SipMessage ack) {
        signNanos = context.timers().nowNanos();
        if (invite != null && invite.request().cseq() == ack.cseq()) {
            invite.acknowledged();
            if (invite.request().body().length == 0 && ack.body().length > 0) {
                takeDescription(ack);
            }
        }
    }

    /** A request of the phone within the dialog. */
    void request(ServerTransaction request) {
        signNanos = context.timers().nowNanos();
        SipMessage message = request.request();
        if (!dialog.isInOrder(message)) {
            request.respond(500, "Server Internal Error: CSeq is not above the last one");
            return;
        }
        switch (message.method()) {
            case "BYE" -> {
                request.respond(200, "OK");
                cause = Cause.NORMAL_CALL_CLEARING;
                if (machine.state() == SipCallState.RINGING || machine.state() == SipCallState.CANCELLING) {
                    return; // the final response to INVITE follows
                }
                machine.fire(SipCallEvent.PHONE_ENDED);
            }
            case "INVITE" -> invitedAgain(request);
            case "INFO" -> key(request);
            default -> request.respond(200, "OK");
        }
    }

    /** True if the request waits for an earlier one: it is neither answered nor performed. */
    boolean isHeldBack(SipMessage message) {
        return message.method().equals("INFO") && dialog.isAwaited(message);
    }

    private void invitedAgain(ServerTransaction request) {
        if (machine.state() != SipCallState.ACTIVE || invite != null && invite.isOpen()) {
            request.respond(491, "Request Pending");
        } else if (request.request().body().length > 0 && !takeDescription(request.request())) {
            request.respond(488, "Not Acceptable Here: expected PCMA or PCMU over RTP/AVP");
        } else {
            invite = request;
            dialog.retarget(request.request(), request.peer());
            sendOk();
        }
    }

    /** A key by INFO: {@code Signal=5}, or the key alone. */
    private void key(ServerTransaction request) {
        SipMessage message = request.request();
        String text = message.text().strip();
        String key;
        switch (message.contentType()) {
            case "application/dtmf-relay" ->
                key = text.lines()
                        .map(line -> line.split("=", 2))
                        .filter(parts -> parts.length == 2 && parts[0].strip().equalsIgnoreCase("Signal"))
                        .map(parts -> parts[1].strip())
                        .findFirst()
                        .orElse("");
            case "application/dtmf" -> key = text;
            default -> {
                request.send(request.response(415, "Unsupported Media Type")
                        .with("Accept", "application/dtmf-relay, application/dtmf"));
                return;
            }
        }
        request.respond(200, "OK");
        String symbol = key.equals("10") ? "*" : key.equals("11") ? "#" : key.toUpperCase(Locale.ROOT);
        if (symbol.length() == 1 && DtmfKey.isKey(symbol.charAt(0))) {
            speech.keyByInfo(DtmfKey.of(symbol.charAt(0)));
        }
    }

    private boolean takeDescription(SipMessage message) {
        Optional<Sdp> found = message.contentType().equals(SDP) ? Sdp.parse(message.text()) : Optional.<Sdp>empty();
        found.ifPresent(sdp -> {
            description = found;
            speech.describe(sdp, dialog.peer().host());
        });
        return found.isPresent();
    }

    private void perform(SipCallAction action) {
        switch (action) {
            case DIAL -> dial();
            case SEND_RINGING -> invite.send(withContact(invite.response(180, "Ringing")));
            case SEND_OK -> sendOk();
            case SEND_INVITE -> sendInvite();
            case SEND_ACK -> {
                dialog.established(answer);
                context.transactions().transmit(dialog.ack(answer).encode(), dialog.peer());
            }
            case SEND_CANCEL -> cancel();
            case SEND_BYE -> context.transactions().request(dialog.request("BYE"), dialog.peer(), ignored -> {});
            case REFUSE_INVITE -> invite.send(refusal());
            case END_INVITE -> invite.respond(487, "Request Terminated");
            case ANSWER_STATION -> station.answer();
            case CLEAR_STATION -> station.clear(cause);
            case START_SPEECH -> {
                speech.start();
                signNanos = context.timers().nowNanos();
                watch();
            }
            case CLOSE -> {
                context.timers().cancel(watch);
                speech.close();
            }
        }
    }

    private void dial() {
        if (!station.dial(called)) {
            released(Cause.USER_BUSY);
        }
    }

    private SipMessage refusal() {
        int status = SipCauses.status(cause);
        return invite.response(status, SipCauses.reason(status))
                .with("Reason", "Q.850;cause=" + cause.code() + ";text=\"" + cause.title() + "\"");
    }

    private SipMessage withContact(SipMessage response) {
        return response.with("Contact", dialog.contact(number)).with("Allow", SipServer.METHODS);
    }

    private void sendOk() {
        String host = context.transport().hostTowards(dialog.peer());
        versions++;
        boolean isOffered = invite.request().body().length > 0;
        String text = isOffered
                ? description.orElseThrow().answer(host, speech.port(), versions)
                : Sdp.offer(host, speech.port(), versions);
        invite.onUnacknowledged(this::lost);
        invite.send(withContact(invite.response(200, "OK")).withBody(SDP, text));
    }

    private void sendInvite() {
        String host = context.transport().hostTowards(dialog.peer());
        SipMessage request = dialog.request("INVITE")
                .with("Contact", dialog.contact(number))
                .with("Allow", SipServer.METHODS)
                .withBody(SDP, Sdp.offer(host, speech.port(), ++versions));
        outgoing = context.transactions().request(request, dialog.peer(), this::responded);
    }

    private void responded(SipMessage response) {
        int status = response.status();
        if (status < 200) {
            if (isCancelDue) {
                cancel();
            }
            return;
        }
        if (status >= 300) {
            cause = SipCauses.cause(status);
            machine.fire(SipCallEvent.PHONE_REFUSED);
            return;
        }
        boolean isFirst = answer == null;
        answer = response;
        machine.fire(SipCallEvent.PHONE_ANSWERED);
        if (isFirst && isUnderWay() && !takeDescription(response)) {
            cause = Cause.BEARER_SERVICE_NOT_IMPLEMENTED;
            machine.fire(SipCallEvent.PHONE_LOST);
        }
    }

    /** CANCEL follows the first provisional response (9.1). */
    private void cancel() {
        isCancelDue = !outgoing.isProceeding();
        if (!isCancelDue) {
            outgoing.cancel();
        }
    }

    /** Asks a phone without speech for a sign, and ends the call of one that gives none. */
    private void watch() {
        watch = context.timers().start(QUIET_NANOS, () -> {
            long quiet = context.timers().nowNanos() - Math.max(signNanos, speech.heardNanos());
            if (quiet >= LOST_NANOS) {
                lost();
                return;
            }
            if (quiet >= QUIET_NANOS) {
                context.transactions().request(dialog.request("OPTIONS"), dialog.peer(), this::signed);
            }
            watch();
        });
    }

    private void signed(SipMessage response) {
        if (response.status() == 481) {
            lost();
        } else if (response.status() != 408) {
            signNanos = context.timers().nowNanos();
        }
    }
}
