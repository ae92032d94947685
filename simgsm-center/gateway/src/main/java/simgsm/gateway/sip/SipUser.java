package simgsm.gateway.sip;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import simgsm.air.Cause;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;
import simgsm.timer.Timer;

/** A SIP phone as a subscriber: its registration, its station, its call and its messages. */
public final class SipUser {
    /** A phone that has gone keeps its station for 60 s; the network keeps its messages meanwhile. */
    static final long RETURN_NANOS = TimeUnit.SECONDS.toNanos(60);

    private static final long REGISTER_NANOS = TimeUnit.SECONDS.toNanos(5);
    private static final int MOST_UNACKNOWLEDGED = 20;
    private static final String UNIT_NAME = "SimGSM SIP phone";

    /** The binding of a REGISTER. @param contact the URI, letter by letter; @param peer its source */
    record Binding(String contact, SipPeer peer, long endNanos) {}

    private final SipContext context;
    private final SipServer server;
    private final MobileStation station;
    /** The speech of the newest call. */
    private SipSpeech speech;

    private final List<ServerTransaction> waiting = new ArrayList<>();
    /** MESSAGEs that the network has still to acknowledge, by the station's id. */
    private final Map<Integer, ServerTransaction> submitted = new HashMap<>();

    private Binding binding;
    private SipCall call;
    private Timer end;
    private boolean isLeaving;

    SipUser(SipContext context, SipServer server, Msisdn number) {
        this.context = context;
        this.server = server;
        StationIdentity identity = StationIdentity.ofOpenNumber(number, Imei.random(context.random()), UNIT_NAME);
        station = new MobileStation(
                identity, Sim.WITHOUT_KEY, StationOptions.STANDARD, this::read, this::accept, context.random());
        station.answerMessagesLater();
        context.transport().add(station);
    }

    public Msisdn number() {
        return station.identity().number();
    }

    /** The phone's address; empty without a registration. */
    public String from() {
        return binding == null ? "" : binding.peer.toString();
    }

    public boolean isCalling() {
        return call != null && call.isUnderWay();
    }

    public boolean isRegistered() {
        return binding != null;
    }

    boolean isBoundTo(String contact) {
        return binding != null && binding.contact.equals(contact);
    }

    boolean isLeaving() {
        return isLeaving;
    }

    private void read(short[] frame) {
        speech.read(frame);
    }

    /** A REGISTER that binds a contact for this time; the response follows the network's. */
    void register(ServerTransaction request, String contact, int seconds) {
        boolean isNew = binding == null;
        binding = new Binding(contact, request.peer(), context.timers().nowNanos() + TimeUnit.SECONDS.toNanos(seconds));
        restartEnd(TimeUnit.SECONDS.toNanos(seconds), this::unbind);
        station.setMemoryAvailable(true);
        if (station.snapshot().registered()) {
            confirm(request);
            if (isNew) {
                server.listener().joined(number(), from());
            }
        } else {
            waiting.add(request);
            context.timers().start(REGISTER_NANOS, () -> refuseWaiting(request));
        }
    }

    private void refuseWaiting(ServerTransaction request) {
        if (waiting.remove(request)) {
            request.send(
                    request.response(503, "Service Unavailable: no network").with("Retry-After", "5"));
            unbind();
        }
    }

    /** The response to REGISTER: the binding and its time. */
    void confirm(ServerTransaction request) {
        SipMessage answer = request.response(200, "OK");
        if (binding != null) {
            long seconds = TimeUnit.NANOSECONDS.toSeconds(
                    binding.endNanos - context.timers().nowNanos());
            answer.with("Contact", "<" + binding.contact + ">;expires=" + seconds);
        }
        request.send(answer);
    }

    /** The phone has gone: its call ends at once. */
    void unbind() {
        if (binding == null) {
            return;
        }
        boolean wasJoined = waiting.isEmpty();
        binding = null;
        station.setMemoryAvailable(false);
        if (call != null) {
            call.lost();
        }
        if (wasJoined) {
            server.listener().left(number());
        }
        restartEnd(RETURN_NANOS, this::leave);
    }

    private void restartEnd(long nanos, Runnable action) {
        context.timers().cancel(end);
        end = context.timers().start(nanos, action);
    }

    /** Detaches the station. */
    void leave() {
        unbind();
        context.timers().cancel(end);
        isLeaving = true;
        context.transport().remove(station, () -> server.gone(this));
    }

    /** A phone's INVITE. */
    void invited(ServerTransaction request, Msisdn to) {
        if (isCalling()) {
            request.respond(486, "Busy Here");
        } else {
            newCall();
            call.invited(request, to);
        }
    }

    private void newCall() {
        speech = new SipSpeech(context.random(), context.timers()::nowNanos);
        call = new SipCall(context, station, speech);
    }

    Optional<SipCall> call() {
        return Optional.ofNullable(call);
    }

    /** A phone's MESSAGE: 202 once the network has it. */
    void submit(ServerTransaction request, Msisdn to) {
        String text = request.request().text();
        if (submitted.size() >= MOST_UNACKNOWLEDGED || !station.snapshot().powered()) {
            request.respond(503, "Service Unavailable: " + MOST_UNACKNOWLEDGED + " messages wait for the network");
        } else if (text.isEmpty()) {
            request.respond(400, "Bad Request: expected a text");
        } else {
            try {
                submitted.put(station.sendMessage(to, text), request);
            } catch (IllegalArgumentException e) {
                request.respond(513, "Message Too Large");
            }
        }
    }

    private void accept(StationEvent event) {
        context.transport().timePassed();
        if (event instanceof StationEvent.SpeechReceived received) {
            speech.heard(received.samples());
        } else if (event instanceof StationEvent.StationRegistered) {
            registered();
        } else if (event instanceof StationEvent.StationUnregistered lost
                && lost.cause().isPresent()) {
            refused(lost.cause().get().title());
        } else if (event instanceof StationEvent.Ringing ringing) {
            offered(ringing.from());
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            call.alerted();
        } else if (event instanceof StationEvent.Connected) {
            call.connected();
        } else if (event instanceof StationEvent.Released released) {
            call.released(released.cause());
        } else if (event instanceof StationEvent.MessageSent sent) {
            Optional.ofNullable(submitted.remove(sent.id())).ifPresent(request -> request.respond(202, "Accepted"));
        } else if (event instanceof StationEvent.MessageFailed failed) {
            int status = SipCauses.status(failed.cause());
            Optional.ofNullable(submitted.remove(failed.id()))
                    .ifPresent(request -> request.respond(status, SipCauses.reason(status)));
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            sendText(message.from(), message.text());
        }
    }

    private void registered() {
        boolean isAwaited = !waiting.isEmpty();
        waiting.forEach(this::confirm);
        waiting.clear();
        if (isAwaited) {
            server.listener().joined(number(), from());
        }
    }

    private void refused(String title) {
        waiting.forEach(request -> request.respond(403, "Forbidden by the network: " + title));
        leave();
        waiting.clear();
    }

    private void offered(Optional<Msisdn> caller) {
        if (binding == null) {
            station.clear(Cause.DESTINATION_OUT_OF_ORDER);
        } else {
            newCall();
            call.offered(caller, binding.contact, binding.peer);
        }
    }

    /** Sends a text; the network has its acknowledgement once the phone has it. */
    private void sendText(String sender, String text) {
        if (binding == null) {
            station.messageRefused(RpCause.MEMORY_CAPACITY_EXCEEDED);
            return;
        }
        SipPeer peer = binding.peer;
        boolean isNumber = sender.matches("[+0-9]+");
        String from = (isNumber ? "" : "\"" + sender.replaceAll("[\"\\\\\\p{Cntrl}]", "") + "\" ") + "<"
                + context.uri(isNumber ? sender : "message", peer) + ">;tag="
                + context.transactions().randomWord();
        SipMessage request = context.request(
                        "MESSAGE",
                        binding.contact,
                        peer,
                        from,
                        "<" + context.uri(number().digits(), peer) + ">",
                        context.transactions().randomWord(),
                        1)
                .withBody("text/plain;charset=UTF-8", text);
        context.transactions().request(request, peer, this::textAnswered);
    }

    /** A phone that gives no answer, or a temporary refusal, receives the text after its next REGISTER. */
    private void textAnswered(SipMessage response) {
        int status = response.status();
        if (status < 300) {
            station.messageTaken();
        } else if (status == 408 || status == 480 || status >= 500 && status < 600) {
            station.setMemoryAvailable(false);
            station.messageRefused(RpCause.MEMORY_CAPACITY_EXCEEDED);
        } else {
            station.messageRefused(RpCause.INTERWORKING);
        }
    }
}
