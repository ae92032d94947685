package vericommand;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * The command verifier of one robot: reads orders from a call's keys, short messages and programs, verifies each
 * against the robot's status, executes it instruction by instruction, and replies. A deterministic core on the
 * robot's owner thread.
 *
 * <p>One order that moves is executed at a time. Its first motion is announced by tone 6, its end by one outcome;
 * every other order received meanwhile is answered by 6, except orders of nothing but {@code ###} and {@code #*0}.
 */
public final class VeriCommand {
    private final Robot robot;
    private final VeriCommandSettings settings;
    private final VeriCommandListener listener;
    private final ReplyTexts texts;
    private final CommandRecognizer recognizer = new CommandRecognizer();
    private final ListeningRequest listening = new ListeningRequest();
    private final OrderDisplay display;
    private final ReplySender replies;
    private final AnswerLimit answerLimit = new AnswerLimit();
    /** Stop orders, answered when the robot has stopped. */
    private final List<OrderExecution> stops = new ArrayList<>();
    /** Null when no call is up. */
    private OrderOrigin call;
    /** Verified once the robot has stopped after the autonomous behaviour that this order ended; null if none. */
    private OrderExecution deferred;
    /** The order that moves the robot; null if none. */
    private OrderExecution running;
    /** The order that started the robot's process; null if none. */
    private OrderExecution process;

    /** True if the opening of an order has ended the process that received the keys. */
    private boolean hasEndedProcess;

    private boolean reportedUnderWay;

    public VeriCommand(Robot robot, VeriCommandSettings settings, VeriCommandListener listener) {
        this.robot = robot;
        this.settings = settings;
        this.listener = listener;
        texts = new ReplyTexts(settings.language(), robot::unknownType);
        display = new OrderDisplay(texts);
        replies = new ReplySender(robot, settings, listener, texts, display, origin -> isOf(origin, process));
    }

    /** An accepted call is up; a previous one ends. @param caller empty if the network does not give it */
    public void callBegan(String caller) {
        callEnded();
        call = OrderOrigin.call(caller);
        display.begin(caller, OrderSource.CALL);
        listener.changed();
    }

    /** The call is lost or cleared: its orders get no reply; with {@code OnHangup.STOP} the robot brakes if one moves it. */
    public void callEnded() {
        if (call == null) {
            return;
        }
        call.end();
        boolean moves = isOf(call, running) || isOf(call, process);
        boolean brakes = settings.onHangup() == VeriCommandSettings.OnHangup.STOP && moves;
        if (moves) {
            display.callEnded((isOf(call, running) ? running : process).order(), brakes);
        } else if (!recognizer.keys().isEmpty()) {
            display.callEndedWithinOrder();
        }
        call = null;
        hasEndedProcess = false;
        recognizer.reset();
        listening.reset();
        listener.changed();
        if (brakes) {
            robot.brake();
        }
    }

    /** The modem clears the call after 60 s without a key; no order of the call is under way. */
    public void callIdle(int seconds) {
        if (call != null) {
            callEnded();
            display.callIdle(seconds);
            listener.changed();
        }
    }

    private static boolean isOf(OrderOrigin origin, OrderExecution execution) {
        return execution != null && execution.origin() == origin;
    }

    /** A key of the caller; ignored without a call. */
    public void key(char key) {
        if (call == null) {
            return;
        }
        boolean isTaken = isOf(call, process) && robot.takesKeys();
        if (isTaken) {
            robot.pressKey(key);
        }
        if (isTaken && key != '*' || listening.key(key, recognizer.isOpen()) && listener.listen()) {
            // it belongs to the process or opens the ear, and is no stray key of an order
            recognizer.reset();
            return;
        }
        Recognition recognition = recognizer.key(key);
        if (isTaken && recognizer.isOpen()) {
            hasEndedProcess = true;
            robot.endAutonomy(() -> {});
        }
        if (display.source() != OrderSource.CALL) {
            display.begin(call.from(), OrderSource.CALL);
        }
        display.key(key, recognizer.keys());
        handle(recognition, call);
        listener.changed();
    }

    /** Speech of the call, lost frames included, was received: samples measure the time-out of an unfinished order. */
    public void speech(long samples) {
        if (call != null && handle(recognizer.elapsed(samples), call)) {
            listener.changed();
        }
    }

    /**
     * A short message. Replies of this suite are no orders and get no reply; nor do messages without a valid order
     * from a sender with 300 such replies within 60 s, until a minute has passed. Valid orders are always accepted.
     *
     * @param from the number authenticated by the network
     * @param nowNanos the time now, by any monotonic clock
     */
    public void message(String from, String text, long nowNanos) {
        boolean isOpened = text.replaceAll("\\s", "").startsWith("**");
        if (!settings.permits(from) || settings.answered() == VeriCommandSettings.Answered.ORDERS && !isOpened) {
            listener.senderIgnored(from);
        } else if (ReplyForms.isReply(text)) {
            listener.replyIgnored(from);
        } else {
            order(from, OrderText.read(text), nowNanos);
        }
    }

    private void order(String from, Recognition recognition, long nowNanos) {
        boolean isValid = recognition instanceof Recognition.Complete complete
                && !(verdict(complete.order()) instanceof Verdict.NoProcess);
        AnswerLimit.Ruling ruling = isValid ? AnswerLimit.Ruling.ANSWER : answerLimit.decide(from, nowNanos);
        if (ruling == AnswerLimit.Ruling.ANSWER) {
            display.begin(from, OrderSource.MESSAGE);
            handle(recognition, OrderOrigin.message(from));
            listener.changed();
        } else if (ruling == AnswerLimit.Ruling.BE_SILENT) {
            listener.senderSilenced(from);
        }
    }

    /**
     * An order of a program, read like a short message; its operator is permitted to command.
     *
     * @param follower receives the order's course on the owner thread, for the first time before this returns
     */
    public void order(String operator, String text, Consumer<OrderReport> follower) {
        display.begin(operator, OrderSource.PROGRAM);
        handle(OrderText.read(text), OrderOrigin.program(operator, robot::pose, follower));
        listener.changed();
    }

    /**
     * Answers a question of any subscriber, as by USSD: an order of only {@code #*0} by status and pose, any other
     * one by its fault. Nothing moves, and orders under way continue.
     */
    public String query(String text) {
        return texts.answer(OrderText.read(text), robot.status(), robot.pose());
    }

    /** The robot's status has changed without an order; stop orders that waited for standstill are answered. */
    public void statusChanged() {
        if (running == null && deferred == null && robot.status() != RobotStatus.MOVING) {
            answerStops();
        }
        listener.changed();
    }

    /** True if an order, or a process started by this call, is being executed. */
    public boolean isUnderWay() {
        return running != null || deferred != null || !stops.isEmpty() || isOf(call, process);
    }

    /** The immutable data of a window. */
    public VeriCommandSnapshot snapshot() {
        return display.snapshot(call != null, isUnderWay());
    }

    /** @return false while the order is incomplete */
    private boolean handle(Recognition recognition, OrderOrigin origin) {
        if (recognition instanceof Recognition.Pending) {
            return false;
        }
        if (recognition instanceof Recognition.Complete complete && endsAutonomy(complete.order())) {
            defer(new OrderExecution(complete.order(), origin));
        } else {
            settle(verdict(recognition), origin);
        }
        hasEndedProcess = false;
        return true;
    }

    private Verdict verdict(Recognition recognition) {
        return Verdict.of(recognition, robot.status(), robot.processes());
    }

    private Verdict verdict(Order order) {
        return Verdict.of(order, robot.status(), robot.processes());
    }

    private void report(Verdict verdict, OrderOrigin origin) {
        display.verdict(verdict);
        listener.order(verdict.keys(), verdict);
        origin.verified(verdict.word());
    }

    /** An order that only asks for the status leaves the autonomous behaviour running. */
    private boolean endsAutonomy(Order order) {
        return (robot.isAutonomous() || hasEndedProcess)
                && (order.moves() || order.stops())
                && !(verdict(order) instanceof Verdict.NoProcess);
    }

    private void defer(OrderExecution execution) {
        deferred = execution;
        reportUnderWay();
        robot.endAutonomy(this::resumeDeferred);
    }

    private void resumeDeferred() {
        OrderExecution execution = deferred;
        deferred = null;
        Verdict verdict = verdict(execution.order());
        if (execution.isStopOrdered() && execution.order().moves()) {
            report(verdict, execution.origin());
            display.course(execution.order(), OrderCourse.STOPPED);
            replies.send(execution.origin(), texts.stopped(execution.initialProgress()), false);
        } else if (!execution.origin().isEnded()) {
            settle(verdict, execution.origin());
        }
        answerStops();
        listener.changed();
    }

    private void settle(Verdict verdict, OrderOrigin origin) {
        report(verdict, origin);
        if (verdict instanceof Verdict.Accepted accepted) {
            begin(new OrderExecution(accepted.order(), origin));
        } else {
            replies.send(origin, texts.of(verdict));
        }
    }

    private void begin(OrderExecution execution) {
        if (execution.order().moves()) {
            running = execution;
            reportUnderWay();
            proceed();
        } else if (!execution.order().stops()) {
            replies.answerReport(execution);
        } else {
            stops.add(execution);
            reportUnderWay();
            if (robot.status() == RobotStatus.MOVING) {
                Stream.of(running, deferred).filter(Objects::nonNull).forEach(OrderExecution::orderStop);
                robot.brake();
            } else {
                answerStops();
            }
        }
    }

    /** Starts the next motion, or ends the order when an instruction is refused or none is left. */
    private void proceed() {
        while (!running.isComplete()) {
            Instruction current = running.current();
            StatusRules.Treatment treatment = StatusRules.treatment(robot.status(), current);
            if (treatment != StatusRules.Treatment.EXECUTED) {
                int of = running.order().instructions().size();
                end(texts.refusedAfter(treatment.tone(), robot.status(), running.done(), of), OrderCourse.NOT_POSSIBLE);
                return;
            }
            if (current instanceof Instruction.Motion motion) {
                start(motion);
                return;
            }
            running.advance();
            if (current instanceof Instruction.StartProcess starting) {
                start(starting);
                return;
            }
            listener.instructionEnded(current);
        }
        end(texts.done(running.order(), robot.status(), robot.pose()), OrderCourse.EXECUTED);
    }

    private void start(Instruction.Motion motion) {
        if (running.announce()) {
            running.origin().moves();
            if (running.origin().source() == OrderSource.CALL) {
                listener.tone(ReplyTone.EXECUTING);
            }
        }
        robot.start(motion, this::motionEnded);
    }

    /** The order is answered by 6 as its process starts; the end of the process gets its own reply. */
    private void start(Instruction.StartProcess starting) {
        String name = robot.processes().getOrDefault(starting.number(), "");
        if (name.isEmpty()) {
            end(texts.noProcess(new Verdict.NoProcess(running.order(), robot.processes())), OrderCourse.NOT_POSSIBLE);
            return;
        }
        OrderExecution started = running;
        robot.startProcess(starting.number(), started.origin().from());
        process = started;
        end(texts.processStarted(starting.number(), name), OrderCourse.UNDER_WAY);
    }

    /**
     * A process of the robot has ended, whatever started it; if by itself, after the robot has stopped.
     *
     * @param name of the process
     * @param detail reason of a failure; empty if unknown
     */
    public void processEnded(ProcessEnding ending, String name, String detail) {
        OrderExecution ended = process;
        process = null;
        if (ended != null) {
            display.course(ended.order(), OrderCourse.of(ending));
        }
        if (ending != ProcessEnding.REPLACED) {
            Reply reply = texts.processEnded(ending, name, detail, robot.status(), robot.pose());
            if (ended != null) {
                replies.send(ended.origin(), reply);
            } else if (ending != ProcessEnding.DONE) {
                replies.show(reply);
            }
        } else if (ended != null) {
            ended.origin().replaced();
        }
        reportUnderWay();
        listener.changed();
    }

    private void motionEnded(MotionOutcome outcome) {
        listener.instructionEnded(running.current());
        OrderProgress progress = running.progress(outcome.amountDone());
        switch (outcome.ending()) {
            case DONE -> motionDone(progress);
            case BRAKED -> end(texts.stopped(progress), OrderCourse.STOPPED);
            case COLLISION -> end(texts.failed(ReplyTone.COLLISION, progress), OrderCourse.COLLISION);
            case INFINITE_LOOP -> end(texts.failed(ReplyTone.INFINITE_LOOP, progress), OrderCourse.INFINITE_LOOP);
            case ABORTED -> end(texts.aborted(progress, robot.status()), OrderCourse.BROKEN_OFF);
        }
    }

    private void motionDone(OrderProgress progress) {
        running.advance();
        if (running.isCancelled() && !running.isComplete()) {
            end(texts.stopped(progress), OrderCourse.STOPPED);
        } else {
            proceed();
        }
    }

    private void end(Reply reply, OrderCourse course) {
        OrderExecution ended = running;
        running = null;
        display.course(ended.order(), course);
        replies.send(ended.origin(), reply, !ended.isStopOrdered() || ended.isComplete());
        answerStops();
        listener.changed();
    }

    private void answerStops() {
        List<OrderExecution> ended = List.copyOf(stops);
        stops.clear();
        ended.forEach(replies::answerStop);
        reportUnderWay();
    }

    private void reportUnderWay() {
        if (reportedUnderWay != isUnderWay()) {
            reportedUnderWay = isUnderWay();
            listener.underWay(reportedUnderWay);
        }
    }
}
