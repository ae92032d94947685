package simgsm.modem.client;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Instant;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.AnsweringModem;
import simgsm.modem.CallDecision;
import simgsm.modem.ModemEvent;
import simgsm.modem.ModemState;
import simgsm.modem.client.AttachedCallTable.AttachedCallPhase;
import simgsm.modem.client.ModemServiceTable.ServiceAction;
import simgsm.modem.client.ModemServiceTable.ServiceEvent;
import simgsm.modem.client.ModemServiceTable.ServiceState;
import simgsm.state.StateMachine;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.context.StationEvent;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * A real modem in M2's place, as a deterministic core: octets of its line and time in; octets and events out, the same as
 * M2's. It is prepared by {@link SetupStep} whenever its line comes up and whenever it has started again; runs by
 * {@link ModemServiceTable}. One owner thread calls everything except {@link #snapshot} and
 * {@link #state}.
 */
public final class AttachedModem implements AnsweringModem, ModemLine.Party {
    /** {@link #nextDeadlineNanos} of a modem that waits for nothing. */
    public static final long NO_DEADLINE = Long.MAX_VALUE;

    /** Without an octet for this time, no earlier dialogue is under way. */
    static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(300);

    private static final ModemEvent.StateChanged NOT_ASKED =
            new ModemEvent.StateChanged(ModemState.SILENT, "the line is not open yet");

    private static final long ATTENTION_MILLIS = 500;

    /** Interval in which stored messages and the registration are looked at, in case a notice was lost. */
    static final long LOOK_NANOS = TimeUnit.SECONDS.toNanos(30);

    private static final Logger LOG = System.getLogger(AttachedModem.class.getName());

    private final Msisdn number;
    private final Consumer<StationEvent> listener;
    private final Timers timers = new Timers();
    private final CommandDialogue dialogue;
    private final ModemSetup setup;
    private final AttachedCall call;
    private final AttachedMessages messages;
    private final StateMachine<ServiceState, ServiceEvent, ServiceAction> service;
    /** Starting codes that are still expected of the last start. */
    private final Set<StartCode> expectedCodes = EnumSet.allOf(StartCode.class);

    private Timer attentionTimer;
    private Timer lookTimer;
    private boolean registered;
    /** Since the set-up began. */
    private boolean rangMeanwhile;

    private UnsolicitedCode bodyOf = UnsolicitedCode.NEWS;
    private volatile StationSnapshot snapshot;
    private volatile ModemEvent.StateChanged state = NOT_ASKED;

    private enum StartCode {
        CARD("+CPIN:"),
        FUNCTION("+CFUN:"),
        CALLS("Call Ready"),
        MESSAGES("SMS Ready"),
        PHONE_BOOK("PB DONE");

        private final String beginning;

        StartCode(String beginning) {
            this.beginning = beginning;
        }
    }

    /**
     * A modem whose line is down.
     *
     * @param number the SIM's; modems often do not know it
     * @param answerAfterMillis as {@link simgsm.modem.ModemOptions}
     * @param start of the program; messages that the modem has stored before are not answered
     * @param output takes what is sent to the modem, in ISO 8859-1
     * @param admission as {@link AnsweringModem.Maker}
     * @param listener as {@link AnsweringModem.Maker}
     */
    public AttachedModem(
            Msisdn number,
            int answerAfterMillis,
            Instant start,
            Consumer<String> output,
            Function<Optional<Msisdn>, CallDecision> admission,
            Consumer<StationEvent> listener) {
        this.number = number;
        this.listener = listener;
        dialogue = new CommandDialogue(timers, output, new Codes());
        setup = new ModemSetup(dialogue, timers, Integer.MAX_VALUE, this::logged);
        call = new AttachedCall(dialogue, timers, answerAfterMillis, admission, listener);
        messages = new AttachedMessages(dialogue, timers, start, listener);
        service = new StateMachine<>(ModemServiceTable.TABLE, number, this::perform);
        snapshot = current();
    }

    // ---- line and time ---------------------------------------------------------------------------------------------

    /** The line is open. */
    @Override
    public void lineUp(long nowNanos) {
        timePassed(nowNanos);
        expectedCodes.addAll(EnumSet.allOf(StartCode.class));
        service.fire(ServiceEvent.LINE_UP);
        publish();
    }

    /** The line is lost: any call has ended. */
    @Override
    public void lineDown(long nowNanos) {
        timePassed(nowNanos);
        setState(ModemState.SILENT, "the line is lost");
        service.fire(ServiceEvent.LINE_DOWN);
        publish();
    }

    @Override
    public void lineFailed(String reason) {
        setState(ModemState.SILENT, reason);
    }

    /** Octets have come from the modem. */
    @Override
    public void received(byte[] octets, long nowNanos) {
        timePassed(nowNanos);
        dialogue.received(octets);
        if (attentionTimer != null && attentionTimer.isRunning()) {
            startAttentionTimer();
        }
        publish();
    }

    /** Runs the timers that have expired; may be called at any time. */
    @Override
    public void timePassed(long nowNanos) {
        timers.advance(nowNanos);
        publish();
    }

    /** When {@link #timePassed} is to be called next, or {@link #NO_DEADLINE}. */
    @Override
    public long nextDeadlineNanos() {
        return timers.nextDeadlineNanos().orElse(NO_DEADLINE);
    }

    @Override
    public void closing() {
        call.hangUp();
    }

    // ---- for the robot ---------------------------------------------------------------------------------------------

    @Override
    public StationSnapshot snapshot() {
        return snapshot;
    }

    @Override
    public ModemEvent.StateChanged state() {
        return state;
    }

    @Override
    public boolean sendTone(DtmfKey key) {
        return call.sendTone(key);
    }

    @Override
    public int reply(Msisdn to, String text) {
        return messages.send(to, text);
    }

    @Override
    public void setOrderUnderWay(boolean active) {
        call.setOrderUnderWay(active);
    }

    @Override
    public boolean hangUp() {
        return call.hangUp();
    }

    /** Whether the modem is prepared and registered. */
    boolean isInService() {
        return service.state() == ServiceState.READY && registered;
    }

    // ---- service ---------------------------------------------------------------------------------------------------

    private void perform(ServiceAction action) {
        switch (action) {
            case FORGET -> forget();
            case CALL_FOR_ATTENTION -> startAttentionTimer();
            case PREPARE -> {
                rangMeanwhile = false;
                setup.start(this::prepared);
            }
            case SERVE -> serve();
        }
    }

    private void forget() {
        timers.cancel(attentionTimer);
        timers.cancel(lookTimer);
        setup.stop();
        messages.modemLost();
        dialogue.drop();
        call.modemLost();
        setRegistered(false);
    }

    private void startAttentionTimer() {
        timers.cancel(attentionTimer);
        attentionTimer = timers.start(QUIET_NANOS, this::callForAttention);
    }

    /** A prompt may be open from before. */
    private void callForAttention() {
        dialogue.escape();
        dialogue.send(ModemSetup.ATTENTION.within(ATTENTION_MILLIS), answer -> {
            if (answer.isOk()) {
                service.fire(ServiceEvent.ATTENTIVE);
            } else if (answer.ending() == ModemAnswer.Ending.REFUSED) {
                startAttentionTimer();
            }
        });
    }

    /** Without an answer it is asked again at once; a set-up finds that out itself. */
    private void stalled(ModemCommand command) {
        setState(ModemState.SILENT, "no answer to " + command.text());
        if (service.state() != ServiceState.PREPARING) {
            service.fire(ServiceEvent.STALLED);
        }
    }

    private void prepared(ModemSetup done) {
        service.fire(done.has(SetupStep.REGISTRATION) ? ServiceEvent.PREPARED : ServiceEvent.STALLED);
    }

    private void serve() {
        if (setup.losesEqualKeys()) {
            boolean isOff = setup.text(SetupStep.KEY_INTERVAL).matches("\\+DDET: ?0.*");
            String why = isOff ? "reports no keys, +DDET is 0" : "drops the second of two equal keys";
            LOG.log(Level.WARNING, "the modem " + why + "; calls are refused");
        } else if (!setup.hasAll(SetupStep.Need.FOR_CALLS)) {
            LOG.log(Level.WARNING, "the modem does not report keys; calls are refused");
        }
        if (!setup.hasAll(SetupStep.Need.FOR_MESSAGES)) {
            LOG.log(Level.WARNING, "the modem handles no short messages");
        }
        setRegistered(true);
        call.ready(setup);
        messages.ready(setup);
        if (rangMeanwhile || setup.isRinging()) {
            call.rings();
        }
        lookTimer = timers.start(LOOK_NANOS, this::look);
        setState(ModemState.READY, operatorName());
    }

    private void look() {
        lookTimer = timers.start(LOOK_NANOS, this::look);
        messages.lookAgain();
        askRegistration();
    }

    private void askRegistration() {
        dialogue.send(ModemCommand.query("AT+CREG?", "+CREG:"), answer -> {
            if (answer.isOk()) {
                boolean isRegistered = SetupStep.REGISTRATION.verdict(answer) == SetupVerdict.OK;
                setState(
                        isRegistered ? ModemState.READY : ModemState.NO_NETWORK,
                        isRegistered ? operatorName() : answer.content());
                setRegistered(isRegistered);
            }
        });
    }

    private void setRegistered(boolean now) {
        if (now != registered) {
            registered = now;
            listener.accept(
                    now
                            ? new StationEvent.StationRegistered(number)
                            : new StationEvent.StationUnregistered(Optional.empty()));
        }
    }

    /** Reports a change of the state; a new text alone is only kept. */
    private void setState(ModemState now, String text) {
        boolean isNews = state == NOT_ASKED || state.state() != now;
        state = new ModemEvent.StateChanged(now, text);
        if (isNews) {
            boolean isExpected = now == ModemState.READY || service.state() == ServiceState.NO_LINE;
            LOG.log(isExpected ? Level.INFO : Level.WARNING, "modem " + number + ": " + now.word() + ", " + text);
            listener.accept(state);
        }
    }

    private void logged(SetupStep step, ModemCommand command, ModemAnswer answer, SetupVerdict verdict) {
        LOG.log(Level.DEBUG, command.text() + ": " + verdict.word() + ", " + answer.text());
        step.obstacle(answer).ifPresent(obstacle -> setState(obstacle, answer.content()));
    }

    // ---- what the modem says unasked -------------------------------------------------------------------------------

    private final class Codes implements CommandDialogue.Listener {
        @Override
        public void unsolicited(String line) {
            Optional<DtmfDialect> dialect = DtmfDialect.ofReport(line);
            if (dialect.isPresent()) {
                keyReported(dialect.get(), line);
            } else {
                UnsolicitedCode.of(line).ifPresent(code -> coded(code, line));
            }
        }

        @Override
        public void body(String line) {
            if (bodyOf == UnsolicitedCode.MESSAGE_BODY && service.state() == ServiceState.READY) {
                messages.arrived(line);
            }
            bodyOf = UnsolicitedCode.NEWS;
        }

        @Override
        public void unreadable(String line) {
            LOG.log(Level.DEBUG, "unreadable: " + line);
            call.unreadable();
        }

        @Override
        public void stalled(ModemCommand command) {
            AttachedModem.this.stalled(command);
        }
    }

    private void keyReported(DtmfDialect dialect, String line) {
        Optional<DtmfDialect.Report> report = dialect.read(line);
        if (report.isEmpty()) {
            call.unreadable();
        } else {
            report.get().key().ifPresent(key -> call.key(key, report.get().millis()));
        }
    }

    private void coded(UnsolicitedCode code, String line) {
        switch (code) {
            case RING -> {
                rangMeanwhile = true;
                ifReady(call::rings);
            }
            case CALLER -> call.callerNamed(line);
            case CALL_ENDED -> call.cleared();
            case CALL_WAITS -> call.secondCallWaits();
            case MESSAGE_STORED -> ifReady(() -> messages.stored(line));
            case MESSAGE_BODY -> bodyOf = line.startsWith("+CMT:") ? code : UnsolicitedCode.NEWS;
            case REGISTRATION -> ifReady(this::askRegistration);
            case BOOT -> booted();
            case STARTED -> started(line);
            case NEWS -> {
                // nothing to do
            }
        }
    }

    private void ifReady(Runnable action) {
        if (service.state() == ServiceState.READY) {
            action.run();
        }
    }

    private void booted() {
        setState(ModemState.SILENT, "the modem has started again");
        expectedCodes.addAll(EnumSet.allOf(StartCode.class));
        service.fire(ServiceEvent.BOOTED);
    }

    /** The code of a start that was not seen is a start of its own. */
    private void started(String line) {
        boolean expected = false;
        for (StartCode code : StartCode.values()) {
            expected |= line.startsWith(code.beginning) && expectedCodes.remove(code);
        }
        if (!expected) {
            booted();
            expectedCodes.removeIf(code -> line.startsWith(code.beginning));
        }
    }

    // ---- snapshot --------------------------------------------------------------------------------------------------

    private void publish() {
        messages.setInCall(call.phase() == AttachedCallPhase.ACTIVE);
        StationSnapshot now = current();
        if (!now.equals(snapshot)) {
            snapshot = now;
        }
    }

    private StationSnapshot current() {
        return new StationSnapshot(
                true,
                service.state() != ServiceState.NO_LINE,
                registered,
                Optional.empty(),
                false,
                operatorName(),
                callState(),
                call.caller(),
                Optional.empty(),
                Optional.empty());
    }

    private String operatorName() {
        String answer = setup.text(SetupStep.OPERATOR);
        return answer.isEmpty() ? "" : AnswerFields.of(answer).text(2);
    }

    private MobileCallState callState() {
        return switch (call.phase()) {
            case IDLE -> MobileCallState.NULL;
            case RINGING -> MobileCallState.CALL_RECEIVED;
            case ANSWERING -> MobileCallState.CONNECT_REQUEST;
            case ACTIVE -> MobileCallState.ACTIVE;
            case HANGING_UP -> MobileCallState.DISCONNECT_REQUEST;
        };
    }
}
