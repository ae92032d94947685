package simgsm.modem.client;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** Leads a modem through {@link SetupStep}, and stores the accepted commands. */
final class ModemSetup {
    /** Pause before an awaited step is repeated. */
    static final long AGAIN_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

    /** Silence that ends an earlier dialogue. */
    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(300);

    private static final long ATTENTION_MILLIS = 500;

    /** Tests only if the modem answers. */
    static final ModemCommand ATTENTION = ModemCommand.of("AT").within(1_000);

    /** Receives each command with its answer. */
    interface Observer {
        void answered(SetupStep step, ModemCommand command, ModemAnswer answer, SetupVerdict verdict);
    }

    private final CommandDialogue dialogue;
    private final Timers timers;
    private final Observer observer;
    private final int mostTries;
    private final boolean asksSound;
    private final Deque<SetupStep> steps = new ArrayDeque<>();
    private final Deque<ModemCommand> alternatives = new ArrayDeque<>();
    /** The accepted command of each step, with the expected answer. */
    private final Map<SetupStep, ModemCommand> accepted = new EnumMap<>(SetupStep.class);

    private final Map<SetupStep, ModemAnswer> answers = new EnumMap<>(SetupStep.class);
    private final Map<SetupStep, SetupVerdict> verdicts = new EnumMap<>(SetupStep.class);
    private SetupStep step;
    private int tries;
    private Timer again;
    private Timer quiet;
    private Consumer<ModemSetup> done;

    /**
     * @param mostTries of an awaited step; the set-up then continues without it
     * @param asksSound true if the modem is asked for {@link SetupStep#SOUND}
     */
    ModemSetup(CommandDialogue dialogue, Timers timers, int mostTries, boolean asksSound, Observer observer) {
        this.dialogue = dialogue;
        this.timers = timers;
        this.mostTries = mostTries;
        this.asksSound = asksSound;
        this.observer = observer;
    }

    /** Asks the modem for attention after each silence until it answers. @param attentive called once it has */
    void callForAttention(Runnable attentive) {
        timers.cancel(quiet);
        quiet = timers.start(QUIET_NANOS, () -> {
            // leaves a prompt that may be open from before
            dialogue.escape();
            dialogue.send(ATTENTION.within(ATTENTION_MILLIS), answer -> {
                if (answer.isOk()) {
                    attentive.run();
                } else if (answer.ending() == ModemAnswer.Ending.REFUSED) {
                    callForAttention(attentive);
                }
            });
        });
    }

    /** True while {@link #callForAttention} waits for a silence. */
    boolean awaitsSilence() {
        return quiet != null && quiet.isRunning();
    }

    /** Starts from the first step. @param whenDone called once, unless {@link #stop} is called before */
    void start(Consumer<ModemSetup> whenDone) {
        stop();
        done = whenDone;
        accepted.clear();
        answers.clear();
        verdicts.clear();
        steps.addAll(List.of(SetupStep.values()));
        steps.removeIf(each -> each == SetupStep.SOUND && !asksSound);
        nextStep();
    }

    void stop() {
        timers.cancel(quiet);
        timers.cancel(again);
        steps.clear();
        alternatives.clear();
        done = null;
    }

    private void nextStep() {
        step = steps.poll();
        if (step == null) {
            Consumer<ModemSetup> whenDone = done;
            stop();
            whenDone.accept(this);
            return;
        }
        tries = 0;
        tryStep();
    }

    private void tryStep() {
        tries++;
        alternatives.clear();
        alternatives.addAll(step.alternatives(text(SetupStep.MANUFACTURER)));
        if (step == SetupStep.HANG_UP && isRinging()) {
            accepted.put(step, alternatives.element());
            nextStep();
        } else {
            tryNext();
        }
    }

    private void tryNext() {
        ModemCommand command = alternatives.remove();
        SetupStep asked = step;
        Consumer<ModemSetup> run = done;
        dialogue.send(command, answer -> {
            if (done == run && done != null && answer.ending() != ModemAnswer.Ending.LOST) {
                answered(asked, command, answer);
            }
        });
    }

    private void answered(SetupStep asked, ModemCommand command, ModemAnswer answer) {
        SetupVerdict verdict = asked.verdict(answer);
        observer.answered(asked, command, answer, verdict);
        answers.put(asked, answer);
        verdicts.put(asked, verdict);
        if (answer.ending() == ModemAnswer.Ending.TIMED_OUT) {
            askWhetherItAnswers(command, verdict);
        } else {
            goOn(asked, command, verdict);
        }
    }

    /** A modem that does not answer at all is not asked the rest. */
    private void askWhetherItAnswers(ModemCommand command, SetupVerdict verdict) {
        SetupStep late = step;
        Consumer<ModemSetup> run = done;
        dialogue.send(ATTENTION, answer -> {
            if (done != run || done == null) {
                return;
            }
            if (answer.isOk()) {
                goOn(late, command, verdict);
            } else {
                steps.clear();
                nextStep();
            }
        });
    }

    private void goOn(SetupStep asked, ModemCommand command, SetupVerdict verdict) {
        if (verdict == SetupVerdict.OK) {
            accepted.put(asked, command);
            nextStep();
        } else if (!alternatives.isEmpty()) {
            tryNext();
        } else if (asked.need() == SetupStep.Need.AWAITED && tries < mostTries) {
            again = timers.start(AGAIN_NANOS, this::tryStep);
        } else {
            nextStep();
        }
    }

    /** True if a call rings, which is not hung up, unlike an earlier one. */
    boolean isRinging() {
        return answers.containsKey(SetupStep.CALL_LIST)
                && answers.get(SetupStep.CALL_LIST).lines().stream()
                        .anyMatch(line -> AnswerFields.of(line).number(2) == AttachedCall.CALL_INCOMING);
    }

    boolean has(SetupStep wanted) {
        return accepted.containsKey(wanted);
    }

    /** The successful command of a step; only after {@link #has}. */
    ModemCommand command(SetupStep of) {
        return accepted.get(of);
    }

    /** True if all steps needed for this, and all awaited steps, have succeeded. */
    boolean hasAll(SetupStep.Need need) {
        for (SetupStep each : SetupStep.values()) {
            if ((each.need() == need || each.need() == SetupStep.Need.AWAITED) && !has(each)) {
                return false;
            }
        }
        return true;
    }

    /** True if the modem reports keys without losses. */
    boolean reportsKeys() {
        return hasAll(SetupStep.Need.FOR_KEYS) && !losesEqualKeys();
    }

    /** True if the modem drops the second of two equal keys: its orders could be misread. */
    boolean losesEqualKeys() {
        return verdicts.get(SetupStep.KEY_INTERVAL) == SetupVerdict.UNEXPECTED;
    }

    /** The missing abilities of the modem, in words that follow "the modem". */
    List<String> shortcomings() {
        List<String> all = new ArrayList<>();
        String calls = asksSound ? "; its calls need its sound" : "; calls are refused";
        if (losesEqualKeys()) {
            boolean isOff = text(SetupStep.KEY_INTERVAL).matches("\\+DDET: ?0.*");
            all.add((isOff ? "reports no keys, +DDET is 0" : "drops the second of two equal keys") + calls);
        } else if (!reportsKeys()) {
            all.add("does not report keys" + calls);
        }
        if (!hasAll(SetupStep.Need.FOR_CALLS)) {
            all.add("lists no calls, or does not hang up; calls are refused");
        }
        if (!hasAll(SetupStep.Need.FOR_MESSAGES)) {
            all.add("handles no short messages");
        }
        return all;
    }

    /** The joined lines of a step's answer; empty before the step. */
    String text(SetupStep of) {
        return answers.containsKey(of) ? String.join(" ", answers.get(of).lines()) : "";
    }

    /** As answered by the modem; empty before. */
    String operatorName() {
        String answer = text(SetupStep.OPERATOR);
        return answer.isEmpty() ? "" : AnswerFields.of(answer).text(2);
    }
}
