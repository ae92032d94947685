package simgsm.modem.client;

import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.event.EventLine;
import simgsm.modem.line.ModemLine;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Tests a modem with the commands of {@link SetupStep}, one by one, and reports each answer. A deterministic core.
 */
public final class ModemCheck implements ModemLine.Party {
    /**
     * Answer to {@code --modem-check}: ok, missing or unexpected.
     *
     * @param answer its lines and its final result in one line, or the reason for its absence
     */
    @EventLine("check command= answer= verdict=verdict.word")
    public record Result(String command, String answer, SetupVerdict verdict) {}

    /** 5 s of a modem that is not registered or has a SIM that is not ready. */
    private static final int MOST_TRIES = 10;

    private static final int MOST_CALLS_FOR_ATTENTION = 5;
    private static final long PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(300);

    private final Consumer<Result> results;
    private final Consumer<Boolean> done;
    private final Timers timers = new Timers();
    private final CommandDialogue dialogue;
    private final ModemSetup setup;
    private Timer pause;
    private int callsForAttention;
    private boolean ended;

    /**
     * A check that begins when the line is open.
     *
     * @param output takes text for the modem, in ISO 8859-1
     * @param done called once, with true if the modem can replace M2
     */
    public ModemCheck(Consumer<String> output, Consumer<Result> results, Consumer<Boolean> done) {
        this.results = results;
        this.done = done;
        dialogue = new CommandDialogue(timers, output, new CommandDialogue.Listener() {});
        setup = new ModemSetup(
                dialogue,
                timers,
                MOST_TRIES,
                true,
                (step, command, answer, verdict) -> report(command, answer, verdict));
    }

    @Override
    public void lineUp(long nowNanos) {
        timePassed(nowNanos);
        pause = timers.start(PAUSE_NANOS, this::callForAttention);
    }

    private void callForAttention() {
        callsForAttention++;
        dialogue.escape();
        dialogue.send(ModemSetup.ATTENTION, answer -> {
            if (!answer.isOk() && callsForAttention < MOST_CALLS_FOR_ATTENTION) {
                pause = timers.start(PAUSE_NANOS, this::callForAttention);
                return;
            }
            report(ModemSetup.ATTENTION, answer, answer.isOk() ? SetupVerdict.OK : SetupVerdict.MISSING);
            if (answer.isOk()) {
                setup.start(this::completed);
            } else {
                end(false);
            }
        });
    }

    private void completed(ModemSetup tried) {
        end(tried.hasAll(SetupStep.Need.FOR_CALLS)
                && tried.hasAll(SetupStep.Need.FOR_MESSAGES)
                && (tried.reportsKeys() || tried.has(SetupStep.SOUND)));
    }

    private void report(ModemCommand command, ModemAnswer answer, SetupVerdict verdict) {
        results.accept(new Result(command.text(), answer.text(), verdict));
    }

    private void end(boolean canServe) {
        if (!ended) {
            ended = true;
            done.accept(canServe);
        }
    }

    /** A check is not restarted. */
    @Override
    public void lineDown(long nowNanos) {
        timers.cancel(pause);
        end(false);
    }

    @Override
    public void lineFailed(String reason) {
        results.accept(new Result("open", reason, SetupVerdict.MISSING));
        end(false);
    }

    @Override
    public void received(byte[] octets, long nowNanos) {
        timePassed(nowNanos);
        dialogue.received(octets);
    }

    @Override
    public void timePassed(long nowNanos) {
        timers.advance(nowNanos);
    }

    @Override
    public long nextDeadlineNanos() {
        return timers.nextDeadlineNanos().orElse(ModemLine.NO_DEADLINE);
    }
}
