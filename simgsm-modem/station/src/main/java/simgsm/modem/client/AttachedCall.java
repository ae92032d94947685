package simgsm.modem.client;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.CallDecision;
import simgsm.modem.CallWords;
import simgsm.modem.Modem;
import simgsm.modem.ModemEvent;
import simgsm.modem.client.AttachedCallTable.AttachedCallPhase;
import simgsm.modem.client.AttachedCallTable.CallAction;
import simgsm.modem.client.AttachedCallTable.CallEvent;
import simgsm.state.StateMachine;
import simgsm.station.context.StationEvent;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * The call of an attached modem; runs by {@link AttachedCallTable}, under {@link CallSupervision}. While there is
 * {@link AttachedSound}, only the keys heard in it count, at once.
 */
final class AttachedCall implements AttachedSound.Listener {
    /** Time-out of a list of calls at other times, and of a tone. */
    static final int LIMIT_MILLIS = 2_000;
    /** RING is repeated every 3 to 6 s. */
    static final long RING_GUARD_NANOS = TimeUnit.SECONDS.toNanos(7);
    /** As M2. */
    static final long IDLE_NANOS = TimeUnit.SECONDS.toNanos(Modem.IDLE_SECONDS);

    private static final Logger LOG = System.getLogger(AttachedCall.class.getName());
    private static final long TICK_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
    private static final int SAMPLES_PER_TICK = 800;
    private static final long NANOS_PER_SAMPLE = 125_000;
    /** State of {@code +CLCC} (TS 27.007, 7.18). */
    static final int CALL_INCOMING = 4;

    private final CommandDialogue dialogue;
    private final Timers timers;
    private final long answerAfterNanos;
    private final Function<Optional<Msisdn>, CallDecision> admission;
    private final Consumer<StationEvent> listener;
    private final StateMachine<AttachedCallPhase, CallEvent, CallAction> machine;
    private final AttachedSound sound;
    private final AttachedTones tones;
    private final CallSupervision supervision;
    private ModemSetup setup;

    private Optional<Msisdn> caller = Optional.empty();
    private boolean reported;
    private boolean accepted;
    private DtmfKey greeting;
    private Cause cause = Cause.NORMAL_CALL_CLEARING;
    private boolean orderActive;
    private long connectedNanos;
    private Timer answerTimer;
    private Timer ringGuard;
    private Timer tickTimer;
    private Timer idleTimer;

    AttachedCall(
            CommandDialogue dialogue,
            Timers timers,
            AttachedSound sound,
            int answerAfterMillis,
            Function<Optional<Msisdn>, CallDecision> admission,
            Consumer<StationEvent> listener) {
        this.dialogue = dialogue;
        this.timers = timers;
        this.sound = sound;
        this.admission = admission;
        this.listener = listener;
        answerAfterNanos = TimeUnit.MILLISECONDS.toNanos(answerAfterMillis);
        machine = new StateMachine<>(AttachedCallTable.TABLE, "attached modem", this::perform);
        sound.setListener(this);
        supervision = new CallSupervision(this, dialogue, timers, listener);
        tones = new AttachedTones(dialogue, timers, sound, this::toneEnded);
    }

    void ready(ModemSetup whatItCan) {
        setup = whatItCan;
    }

    AttachedCallPhase phase() {
        return machine.state();
    }

    Optional<Msisdn> caller() {
        return caller;
    }

    // ---- from the modem --------------------------------------------------------------------------------------------

    void rings() {
        machine.fire(CallEvent.RING);
    }

    /** {@code +CLIP: "number",type,...}. */
    void callerNamed(String line) {
        if (phase() == AttachedCallPhase.RINGING) {
            caller = number(AnswerFields.of(line).quoted(0)).or(() -> caller);
        }
    }

    void cleared() {
        clear(CallEvent.CLEARED, Cause.NORMAL_CALL_CLEARING);
    }

    /** Ends any call. */
    void modemLost() {
        clear(CallEvent.MODEM_LOST, Cause.TEMPORARY_FAILURE);
    }

    private void clear(CallEvent event, Cause why) {
        cause = why;
        machine.fire(event);
    }

    /** Handles a report of the modem about a key; empty for a damaged one. */
    void keyReported(Optional<DtmfDialect.Report> report) {
        if (report.isEmpty()) {
            unreadable();
        } else {
            report.get().key().ifPresent(key -> key(key, report.get().millis()));
        }
    }

    private void key(DtmfKey key, OptionalInt millis) {
        if (!isHearing() || sound.isLive()) {
            return;
        }
        LOG.log(Level.INFO, "key " + key.symbol() + (millis.isPresent() ? ", " + millis.getAsInt() + " ms" : ""));
        long now = (timers.nowNanos() - connectedNanos) / NANOS_PER_SAMPLE;
        reported(new ModemEvent.KeyDecided(DtmfDigit.reported(key, now, millis)));
        reported(new ModemEvent.KeyEnded());
    }

    /** A line may have been the report of a key. */
    void unreadable() {
        supervision.disturbed();
        if (isHearing() && !sound.isLive()) {
            reported(new ModemEvent.KeyUnreadable());
        }
    }

    private boolean isHearing() {
        return phase() == AttachedCallPhase.ACTIVE && accepted;
    }

    private void reported(ModemEvent event) {
        restartIdle();
        supervision.report(event);
    }

    /** The network offers a second call, which is refused as busy. */
    void secondCallWaits() {
        if (AttachedCallTable.STANDING.contains(phase())) {
            dialogue.send(ModemCommand.of("AT+CHLD=0"), answer -> {});
        }
    }

    // ---- from the robot --------------------------------------------------------------------------------------------

    boolean sendTone(DtmfKey key) {
        boolean heard = isHearing();
        if (heard) {
            restartIdle();
            tones.queue(key);
        }
        return heard;
    }

    /** The words of the accepted call; none without its sound. */
    CallWords words() {
        return isHearing() ? sound.words() : CallWords.NONE;
    }

    void setOrderUnderWay(boolean active) {
        orderActive = active;
        restartIdle();
    }

    boolean hangUp() {
        cause = Cause.NORMAL_CALL_CLEARING;
        return machine.fire(CallEvent.HANG_UP);
    }

    // ---- the machine -----------------------------------------------------------------------------------------------

    private void perform(CallAction action) {
        switch (action) {
            case ASK_CALLER -> askCaller();
            case START_RING_GUARD -> {
                timers.cancel(ringGuard);
                ringGuard = timers.start(RING_GUARD_NANOS, this::cleared);
            }
            case REPORT_RINGING -> reportRinging();
            case START_ANSWER_TIMER -> startAnswerTimer();
            case SEND_ANSWER -> answer();
            case BEGIN -> begin();
            case SEND_HANG_UP -> dialogue.sendFirst(hangUpCommand(), this::hungUp);
            case REPORT_RELEASED -> reportReleased();
            case STOP_TIMERS -> stopTimers();
        }
    }

    /** A modem that has confirmed neither command at set-up may still accept the one of V.250. */
    private ModemCommand hangUpCommand() {
        return setup.has(SetupStep.HANG_UP) ? setup.command(SetupStep.HANG_UP) : ModemCommand.ofCall("ATH");
    }

    private void hungUp(ModemAnswer answer) {
        if (answer.ending() != ModemAnswer.Ending.LOST) {
            machine.fire(CallEvent.HUNG_UP);
        }
    }

    private void askCaller() {
        caller = Optional.empty();
        reported = false;
        accepted = false;
        dialogue.send(list(), answer -> {
            for (String line : answer.lines()) {
                caller = caller.or(() -> number(AnswerFields.of(line).quoted(0)));
            }
            // a RING may be under way after its call has ended; a call still up rings again
            boolean ended = answer.isOk() && answer.lines().isEmpty();
            machine.fire(ended ? CallEvent.CLEARED : CallEvent.CALLER_KNOWN);
        });
    }

    /** The list of calls. */
    static ModemCommand list() {
        return ModemCommand.query("AT+CLCC", "+CLCC:").within(LIMIT_MILLIS);
    }

    static Optional<Msisdn> number(String text) {
        try {
            return text.isEmpty() ? Optional.empty() : Optional.of(Msisdn.parse(text));
        } catch (IllegalArgumentException notANumber) {
            return Optional.empty();
        }
    }

    private void reportRinging() {
        reported = true;
        listener.accept(new StationEvent.Ringing(caller));
    }

    private void startAnswerTimer() {
        if (!setup.hasAll(SetupStep.Need.FOR_CALLS) || !setup.reportsKeys() && !sound.isOpen()) {
            LOG.log(Level.WARNING, "call refused: the modem does not report keys as an order needs them");
            hangUp();
        } else {
            answerTimer = timers.start(answerAfterNanos, () -> machine.fire(CallEvent.ANSWER_DUE));
        }
    }

    private void answer() {
        CallDecision decision = admission.apply(caller);
        accepted = decision.accepted();
        greeting = decision.tone();
        dialogue.sendFirst(ModemCommand.ofCall("ATA"), answer -> {
            if (answer.isOk()) {
                machine.fire(CallEvent.ANSWERED);
            } else if (answer.ending() == ModemAnswer.Ending.REFUSED) {
                cleared();
            }
        });
    }

    private void begin() {
        connectedNanos = timers.nowNanos();
        orderActive = false;
        supervision.begin();
        tickTimer = timers.start(TICK_NANOS, this::tick);
        restartIdle();
        sound.begin();
        if (sound.isLive() && setup.has(SetupStep.SOUND)) {
            dialogue.sendFirst(SoundDialect.switchOn(setup.command(SetupStep.SOUND)), answer -> {});
        }
        tones.queue(greeting);
        if (accepted) {
            listener.accept(new StationEvent.Connected(caller));
        }
    }

    private void stopTimers() {
        supervision.end();
        for (Timer timer : new Timer[] {answerTimer, ringGuard, tickTimer, idleTimer}) {
            timers.cancel(timer);
        }
    }

    private void reportReleased() {
        tones.drop();
        sound.end();
        if (reported) {
            listener.accept(new StationEvent.Released(cause));
        }
        caller = Optional.empty();
    }

    private void tick() {
        tickTimer = timers.start(TICK_NANOS, this::tick);
        if (accepted && !sound.isLive()) {
            sound.skip(SAMPLES_PER_TICK);
            listener.accept(new ModemEvent.SpeechProcessed(SAMPLES_PER_TICK));
        }
    }

    private void restartIdle() {
        timers.cancel(idleTimer);
        if (phase() == AttachedCallPhase.ACTIVE && !orderActive) {
            idleTimer = timers.start(IDLE_NANOS, this::idle);
        }
    }

    private void idle() {
        if (accepted) {
            listener.accept(new ModemEvent.CallIdle(Modem.IDLE_SECONDS));
        }
        hangUp();
    }

    private void toneEnded(DtmfKey key, boolean sent) {
        restartIdle();
        listener.accept(sent ? new ModemEvent.ReplyToneSent(key) : new ModemEvent.ReplyToneFailed(key));
        if (!accepted) {
            hangUp();
        }
    }

    @Override
    public void heard(StationEvent event) {
        if (event instanceof ModemEvent.KeyDecided || words().isListening()) {
            restartIdle();
        }
        if (isHearing()) {
            listener.accept(event);
        }
    }

    @Override
    public void toneSent(DtmfKey key) {
        tones.ended(key, true);
    }

    @Override
    public void soundChanged(String why) {
        LOG.log(Level.WARNING, why.isEmpty() ? "the modem's sound is back" : why);
        heard(new ModemEvent.KeyUnreadable());
        if (!why.isEmpty() && setup.reportsKeys()) {
            tones.soundLost();
        } else if (!why.isEmpty()) {
            clear(CallEvent.HANG_UP, Cause.TEMPORARY_FAILURE);
        }
    }
}
