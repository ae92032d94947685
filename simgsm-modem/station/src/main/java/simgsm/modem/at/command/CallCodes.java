package simgsm.modem.at.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.modem.at.AddressType;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.KeyRun;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.context.StationEvent;
import simgsm.timer.Timer;

/**
 * The terminal's call as seen by clients, and its unsolicited codes: RING, +CLIP, +CCWA, +CSSI, NO CARRIER and the like.
 */
final class CallCodes {
    /** Interval of RING. */
    static final long RING_NANOS = TimeUnit.SECONDS.toNanos(3);

    /** Reason in ^CEND of a call that ended in order; the cause follows it. */
    private static final int RELEASED = 67;

    /** Voice, in +CLCC and +CCWA. */
    private static final int VOICE = 1;

    /** Notifications of supplementary services, by +CSSN (TS 27.007, 7.17). */
    private static final Map<Class<? extends StationEvent.OfCall>, String> SERVICE_CODES = Map.of(
            StationEvent.ForwardingActive.class, "+CSSI: 0",
            StationEvent.CallForwarded.class, "+CSSI: 2",
            StationEvent.ForwardedBy.class, "+CSSU: 0",
            StationEvent.HeldByPeer.class, "+CSSU: 2",
            StationEvent.RetrievedByPeer.class, "+CSSU: 3",
            StationEvent.IncomingCallForwarded.class, "+CSSU: 10");

    private record HeldParty(String number, boolean isIncoming) {}

    private final AtModem modem;
    private boolean isPresent;
    private boolean isIncoming;
    private boolean isConnected;
    private long connectedNanos;
    /** As dialled, or as given by the network; empty if unknown. */
    private String number = "";

    private Optional<StationEvent.CallWaits> waiting = Optional.empty();
    private boolean answersWaiting;
    /** The held call; retrieved at the end of the active one if +CHLD=1 asked for that. */
    private Optional<HeldParty> held = Optional.empty();

    /** The call held when another was parked: the two are being swapped. */
    private Optional<HeldParty> beingRetrieved = Optional.empty();

    private boolean retrieves;
    private Timer ringTimer;
    private int rings;
    private Optional<Cause> lastCause = Optional.empty();
    /** The client that has hung up; it reads OK, and no code after it. */
    private AtClient hangingUp;

    private AtRequest answering;
    private final List<AtRequest> sendingKeys = new ArrayList<>();

    CallCodes(AtModem modem) {
        this.modem = modem;
    }

    // ---- commands -----------------------------------------------------------------------------------------------

    /** @return false if it is not possible now */
    boolean dial(String dialled, Msisdn to) {
        boolean begun = modem.terminal().dial(to);
        if (begun) {
            number = dialled;
        }
        return begun;
    }

    AtResult answer(AtRequest request) {
        if (answering != null) {
            return AtResult.NO_CARRIER;
        }
        answering = request;
        if (!modem.terminal().answer()) {
            answering = null;
            return AtResult.NO_CARRIER;
        }
        return AtResult.PENDING;
    }

    void hangUp(AtClient client) {
        hangingUp = client;
        modem.terminal().hangUp();
        hangingUp = null;
    }

    /** +CHLD. @return false if it is not possible now */
    boolean supplementary(int operation, AtClient client) {
        if (operation == 0 && (waiting.isPresent() || held.isPresent())) {
            return modem.terminal().rejectWaiting();
        }
        if (operation == 2) {
            return modem.terminal().hold();
        }
        if (operation == 1 && isPresent) {
            answersWaiting = waiting.isPresent();
            retrieves = held.isPresent();
            hangUp(client);
            return true;
        }
        return false;
    }

    AtResult sendKeys(AtRequest request, List<KeyRun> runs) {
        sendingKeys.add(request);
        Runnable allSent = () -> {
            sendingKeys.remove(request);
            request.finish(AtResult.OK);
        };
        for (KeyRun run : runs) {
            boolean isLast = run == runs.get(runs.size() - 1);
            modem.terminal().sendKeys(run.keys(), run.millis(), isLast ? allSent : () -> {});
        }
        return AtResult.PENDING;
    }

    boolean isActive() {
        return modem.terminal().station().snapshot().callState() == MobileCallState.ACTIVE;
    }

    boolean isRinging() {
        return isPresent && isIncoming && !isConnected;
    }

    Optional<Cause> lastCause() {
        return lastCause;
    }

    /** The calls in the form of +CLCC, without its name: index, direction, state, voice, no conference, number. */
    List<String> list() {
        List<String> calls = new ArrayList<>();
        state().ifPresent(state -> calls.add("1," + (isIncoming ? 1 : 0) + "," + state + ",0,0" + address(number)));
        held.ifPresent(call -> calls.add("2," + (call.isIncoming ? 1 : 0) + ",1,0,0" + address(call.number)));
        waiting.ifPresent(call -> calls.add("2,1,5,0,0" + address(shown(call.from()))));
        return calls;
    }

    /** 0 active, 2 dialling, 3 alerting, 4 incoming (TS 27.007, 7.18). */
    private Optional<Integer> state() {
        return switch (modem.terminal().station().snapshot().callState()) {
            case ACTIVE -> Optional.of(0);
            case MM_CONNECTION_PENDING, CALL_INITIATED, MO_CALL_PROCEEDING -> Optional.of(2);
            case CALL_DELIVERED -> Optional.of(3);
            case CALL_PRESENT, MT_CALL_CONFIRMED, CALL_RECEIVED, CONNECT_REQUEST -> Optional.of(4);
            default -> Optional.empty();
        };
    }

    /** 0 none, 1 incoming, 2 outgoing, 3 alerting at the far end: the indicator callsetup. */
    int setup() {
        return switch (state().orElse(0)) {
            case 2 -> 2;
            case 3 -> 3;
            case 4 -> 1;
            default -> waiting.isPresent() ? 1 : 0;
        };
    }

    private static String address(String number) {
        return number.isEmpty() ? "" : ",\"" + number + "\"," + AddressType.of(number);
    }

    private static String shown(Optional<Msisdn> number) {
        return number.map(Msisdn::toString).orElse("");
    }

    // ---- events -------------------------------------------------------------------------------------------------

    void accept(StationEvent.OfCall event) {
        Optional.ofNullable(SERVICE_CODES.get(event.getClass())).ifPresent(this::reportService);
        if (event instanceof StationEvent.Calling calling) {
            begin(false, calling.number().toString());
            modem.books().dialled(number);
            reportProgress("^ORIG:1,0");
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            reportProgress("^CONF:1");
        } else if (event instanceof StationEvent.Ringing ringing) {
            begin(true, shown(ringing.from()));
            rings();
        } else if (event instanceof StationEvent.Connected connected) {
            number = shown(connected.peer());
            connected();
        } else if (event instanceof StationEvent.Released released) {
            released(released.cause());
        } else if (event instanceof StationEvent.CallWaits waits) {
            waiting = Optional.of(waits);
            reportWaiting(waits);
        } else if (event instanceof StationEvent.WaitingCallEnded) {
            waiting = Optional.empty();
        } else if (event instanceof StationEvent.CallHeld) {
            held();
        } else if (event instanceof StationEvent.CallRetrieved) {
            retrieved();
        } else if (event instanceof StationEvent.HeldCallEnded) {
            held = Optional.empty();
            modem.clients().stream()
                    .filter(client -> client != hangingUp)
                    .forEach(client -> client.report(AtResult.NO_CARRIER));
        }
    }

    /** A waiting call is answered next and is the current one from now on. */
    private void held() {
        HeldParty parked = new HeldParty(number, isIncoming);
        beingRetrieved = held;
        held = Optional.of(parked);
        isPresent = waiting.isPresent();
        isConnected = false;
        modem.keys().callEnded();
        waiting.ifPresent(call -> {
            number = shown(call.from());
            isIncoming = true;
        });
        waiting = Optional.empty();
    }

    private void retrieved() {
        HeldParty back = beingRetrieved.or(() -> held).orElse(new HeldParty("", true));
        if (beingRetrieved.isEmpty()) {
            held = Optional.empty();
        }
        beingRetrieved = Optional.empty();
        number = back.number();
        isIncoming = back.isIncoming();
        isPresent = true;
        isConnected = true;
        modem.keys().reset();
    }

    private void begin(boolean incoming, String digits) {
        boolean isAsDialled = !incoming && number.replace("+", "").equals(digits);
        number = isAsDialled ? number : digits;
        isPresent = true;
        isIncoming = incoming;
        isConnected = false;
        rings = 0;
        if (incoming) {
            waiting = Optional.empty();
        }
    }

    private void rings() {
        if (answersWaiting) {
            answersWaiting = false;
            modem.terminal().answer();
            return;
        }
        if (modem.clients().stream()
                .anyMatch(client -> KeptSettings.kept(client, "+GSMBUSY").equals("1"))) {
            modem.terminal().hangUp();
            return;
        }
        rings++;
        for (AtClient client : modem.clients()) {
            client.reportTogether(() -> reportRinging(client));
        }
        if (modem.clients().stream()
                .anyMatch(client ->
                        client.settings().ringsBeforeAnswer > 0 && rings >= client.settings().ringsBeforeAnswer)) {
            modem.terminal().answer();
        } else {
            ringTimer = modem.timers().start(RING_NANOS, this::rings);
        }
    }

    private void reportRinging(AtClient client) {
        if (client.settings().namesRingKind) {
            client.report("+CRING: VOICE");
        } else {
            client.report(AtResult.RING);
        }
        if (client.settings().showsCaller) {
            client.report("+CLIP: \"" + number + "\"," + AddressType.of(number) + modem.profile().callerFields
                    + (number.isEmpty() ? 1 : 0));
        }
    }

    private void connected() {
        isConnected = true;
        modem.timers().cancel(ringTimer);
        modem.keys().reset();
        finishAnswer(AtResult.OK);
        connectedNanos = modem.timers().nowNanos();
        reportProgress("^CONN:1,0");
        if (isIncoming) {
            modem.books().answered(number);
        } else {
            reportTo(
                    client -> client.settings().showsConnectedNumber,
                    "+COLP: \"" + number + "\"," + AddressType.of(number));
        }
    }

    private void finishAnswer(AtResult result) {
        AtRequest request = answering;
        answering = null;
        if (request != null) {
            request.finish(result);
        }
    }

    private void released(Cause cause) {
        modem.timers().cancel(ringTimer);
        modem.keys().callEnded();
        if (isIncoming && !isConnected) {
            modem.books().missed(number);
        }
        lastCause = Optional.of(cause);
        AtResult code = code(cause);
        long seconds =
                isConnected ? TimeUnit.NANOSECONDS.toSeconds(modem.timers().nowNanos() - connectedNanos) : 0;
        reportProgress("^CEND:1," + seconds + "," + RELEASED + "," + cause.code());
        modem.sound().setOn(false);
        isPresent = false;
        isConnected = false;
        number = "";
        finishAnswer(AtResult.NO_CARRIER);
        keysRefused();
        for (AtClient client : modem.clients()) {
            if (client != hangingUp) {
                client.report(code == AtResult.BUSY && client.settings().callProgress < 3 ? AtResult.NO_CARRIER : code);
            }
        }
        if (retrieves) {
            retrieves = false;
            modem.terminal().hold();
        }
    }

    /** The queued keys will not be sent. */
    void keysRefused() {
        List<AtRequest> unsent = List.copyOf(sendingKeys);
        sendingKeys.clear();
        unsent.forEach(request -> request.finish(AtResult.ERROR));
    }

    private AtResult code(Cause cause) {
        if (isIncoming || isConnected) {
            return AtResult.NO_CARRIER;
        }
        return switch (cause) {
            case USER_BUSY -> AtResult.BUSY;
            case NO_USER_RESPONDING, USER_ALERTING_NO_ANSWER -> AtResult.NO_ANSWER;
            default -> AtResult.NO_CARRIER;
        };
    }

    private void reportWaiting(StationEvent.CallWaits call) {
        String caller = shown(call.from());
        reportTo(
                client -> client.settings().showsWaiting,
                "+CCWA: \"" + caller + "\"," + AddressType.of(caller) + "," + VOICE);
    }

    private void reportService(String code) {
        String wished = code.startsWith("+CSSI") ? "1,." : ".,1";
        reportTo(client -> KeptSettings.kept(client, "+CSSN").matches(wished), code);
    }

    private void reportProgress(String line) {
        reportTo(client -> client.settings().takesSound, line);
    }

    private void reportTo(Predicate<AtClient> wish, String line) {
        modem.clients().stream().filter(wish).forEach(client -> client.report(line));
    }
}
