package simgsm.modem.client;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Instant;
import java.util.HashSet;
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
import simgsm.modem.line.ModemLine;
import simgsm.sim.PinLock;
import simgsm.state.StateMachine;
import simgsm.station.StationSnapshot;
import simgsm.station.context.StationEvent;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * A real modem instead of M2, as a deterministic core: input is octets of its line and time, output is octets and the
 * events of M2. It is prepared by {@link SetupStep} whenever its line is opened or it has restarted; runs by {@link
 * ModemServiceTable}. One owner thread calls everything except {@link #snapshot} and {@link #state}.
 */
public final class AttachedModem implements AnsweringModem, ModemLine.Party {
    /** Interval of checks of stored messages and registration, in case a notice was lost. */
    static final long LOOK_NANOS = TimeUnit.SECONDS.toNanos(30);

    /** Codes sent once after each start. */
    private static final Set<String> START_CODES = Set.of("+CPIN:", "+CFUN:", "Call Ready", "SMS Ready", "PB DONE");

    private static final Logger LOG = System.getLogger(AttachedModem.class.getName());

    private final Msisdn number;
    private final Consumer<StationEvent> listener;
    private final Timers timers = new Timers();
    private final CommandDialogue dialogue;
    private final ModemSetup setup;
    private final AttachedCall call;
    private final AttachedMessages messages;
    private final StateMachine<ServiceState, ServiceEvent, ServiceAction> service;
    /** Codes of the last start still expected. */
    private final Set<String> expectedCodes = new HashSet<>(START_CODES);

    private final AttachedSound sound;

    private Timer lookTimer;
    private boolean registered;
    /** True if a call rang since the set-up began. */
    private boolean rangMeanwhile;

    private UnsolicitedCode bodyOf = UnsolicitedCode.NEWS;
    private volatile StationSnapshot snapshot;
    private final ReportedState state;
    private PinEntry pin = PinEntry.NONE;

    /**
     * A modem with its line down.
     *
     * @param number the SIM's, often unknown to modems
     * @param answerAfterMillis as {@link simgsm.modem.ModemOptions}
     * @param start of the program; messages stored in the modem before are not answered
     * @param output takes text for the modem, in ISO 8859-1
     * @param soundPort {@link SoundPort#NONE} if keys are only those that the modem reports
     * @param admission as {@link AnsweringModem.Maker}
     * @param listener as {@link AnsweringModem.Maker}
     */
    public AttachedModem(
            Msisdn number,
            int answerAfterMillis,
            Instant start,
            Consumer<String> output,
            SoundPort soundPort,
            Function<Optional<Msisdn>, CallDecision> admission,
            Consumer<StationEvent> listener) {
        this.number = number;
        this.listener = listener;
        state = new ReportedState("modem " + number, listener);
        dialogue = new CommandDialogue(timers, output, new Codes());
        setup = new ModemSetup(dialogue, timers, Integer.MAX_VALUE, soundPort != SoundPort.NONE, this::logged);
        sound = new AttachedSound(timers, soundPort, state::soundChanged);
        call = new AttachedCall(dialogue, timers, sound, answerAfterMillis, admission, listener);
        messages = new AttachedMessages(dialogue, timers, start, listener);
        service = new StateMachine<>(ModemServiceTable.TABLE, number, this::perform);
        snapshot = current();
    }

    /** Sets the PIN of the modem's SIM, before the start. */
    public void setPin(String code) {
        pin = new PinEntry(code);
    }

    // ---- line and time ---------------------------------------------------------------------------------------------

    /** The line is open. */
    @Override
    public void lineUp(long nowNanos) {
        timePassed(nowNanos);
        expectedCodes.addAll(START_CODES);
        service.fire(ServiceEvent.LINE_UP);
        publish();
    }

    /** The line is lost, and any call has ended. */
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

    /** The line of the sound of calls. */
    public ModemLine.Party sound() {
        return sound;
    }

    @Override
    public void received(byte[] octets, long nowNanos) {
        timePassed(nowNanos);
        dialogue.received(octets);
        if (setup.awaitsSilence()) {
            callForAttention();
        }
        publish();
    }

    /** Runs the timers that have expired; may be called at any time. */
    @Override
    public void timePassed(long nowNanos) {
        timers.advance(nowNanos);
        publish();
    }

    /** Time of the next call of {@link #timePassed}, or {@link ModemLine#NO_DEADLINE}. */
    @Override
    public long nextDeadlineNanos() {
        return timers.nextDeadlineNanos().orElse(ModemLine.NO_DEADLINE);
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
        return state.newest();
    }

    @Override
    public boolean sendTone(DtmfKey key) {
        return call.sendTone(key);
    }

    @Override
    public boolean say(String reply) {
        return call.words().say(reply);
    }

    @Override
    public boolean listensToVoice() {
        return sound.listensToVoice();
    }

    @Override
    public void listen() {
        call.words().listen(call.caller());
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

    // ---- service ---------------------------------------------------------------------------------------------------

    private void perform(ServiceAction action) {
        switch (action) {
            case FORGET -> forget();
            case CALL_FOR_ATTENTION -> callForAttention();
            case PREPARE -> {
                rangMeanwhile = false;
                setup.start(this::prepared);
            }
            case SERVE -> serve();
        }
    }

    private void forget() {
        timers.cancel(lookTimer);
        setup.stop();
        messages.modemLost();
        dialogue.drop();
        call.modemLost();
        setRegistered(false);
    }

    private void callForAttention() {
        setup.callForAttention(() -> service.fire(ServiceEvent.ATTENTIVE));
    }

    /** Asks again at once for an answer; a set-up notices its absence itself. */
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
        setup.shortcomings().forEach(text -> LOG.log(Level.WARNING, "the modem " + text));
        setRegistered(true);
        call.ready(setup);
        messages.ready(setup);
        if (rangMeanwhile || setup.isRinging()) {
            call.rings();
        }
        lookTimer = timers.start(LOOK_NANOS, this::look);
        setState(ModemState.READY, setup.operatorName());
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
                        isRegistered ? setup.operatorName() : answer.content());
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

    private void setState(ModemState now, String text) {
        state.set(now, text, service.state() == ServiceState.NO_LINE);
    }

    private void logged(SetupStep step, ModemCommand command, ModemAnswer answer, SetupVerdict verdict) {
        LOG.log(Level.DEBUG, command.text() + ": " + verdict.word() + ", " + answer.text());
        step.obstacle(answer).ifPresent(obstacle -> {
            setState(obstacle, answer.content());
            if (obstacle == ModemState.SIM_PIN) {
                pin.asked(dialogue);
            }
        });
    }

    // ---- unsolicited codes -----------------------------------------------------------------------------------------

    private final class Codes implements CommandDialogue.Listener {
        @Override
        public void unsolicited(String line) {
            Optional<DtmfDialect> dialect = DtmfDialect.ofReport(line);
            if (dialect.isPresent()) {
                call.keyReported(dialect.get().read(line));
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
        expectedCodes.addAll(START_CODES);
        service.fire(ServiceEvent.BOOTED);
    }

    /** The code of an unseen start counts as a start. */
    private void started(String line) {
        if (!expectedCodes.removeIf(line::startsWith)) {
            booted();
            expectedCodes.removeIf(line::startsWith);
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
                setup.operatorName(),
                call.phase().shown(),
                call.caller(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                PinLock.none().status());
    }
}
