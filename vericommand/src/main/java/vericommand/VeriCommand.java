package vericommand;

import java.util.ArrayList;
import java.util.List;

/**
 * The command verifier of one robot: reads orders from a call's keys and from short messages, verifies each against the
 * robot's status, has it executed instruction by instruction, and answers. A deterministic core on the robot's owner thread.
 *
 * <p>One order that moves is under way at a time. Its first motion is announced by tone 6, its end by one outcome; whatever
 * comes in between is answered by 6, except orders of nothing but {@code ###} and {@code #*0}.
 */
public final class VeriCommand {
    private final Robot robot;
    private final VeriCommandSettings settings;
    private final VeriCommandListener listener;
    private final ReplyTexts texts;
    private final CommandRecognizer recognizer = new CommandRecognizer();
    private final OrderDisplay display;
    /** Stop orders that wait for the robot to stand. */
    private final List<OrderExecution> stops = new ArrayList<>();

    private OrderOrigin call;
    /** Waits for the robot to stand, whose own process it has ended; null when none does. */
    private HeldOrder held;

    private OrderExecution running;
    private boolean toldUnderWay;

    public VeriCommand(Robot robot, VeriCommandSettings settings, VeriCommandListener listener) {
        this.robot = robot;
        this.settings = settings;
        this.listener = listener;
        texts = new ReplyTexts(settings.language());
        display = new OrderDisplay(settings.language(), texts);
    }

    /** An accepted call is up. @param caller empty when the network does not say */
    public void callBegan(String caller) {
        callEnded();
        call = OrderOrigin.call(caller);
        display.begin(caller, false);
        listener.changed();
    }

    /** The call is lost or cleared: what it ordered gets no reply, and unless told otherwise the robot brakes. */
    public void callEnded() {
        if (call == null) {
            return;
        }
        call.leave();
        boolean stopRobot =
                running != null && running.source() == call && settings.onHangup() == VeriCommandSettings.OnHangup.STOP;
        call = null;
        recognizer.reset();
        listener.changed();
        if (stopRobot) {
            robot.brake();
        }
    }

    /** A key of the caller; without a call it is nobody's. */
    public void key(char key) {
        if (call == null) {
            return;
        }
        Recognition recognition = recognizer.key(key);
        if (display.showsMessage()) {
            display.begin(call.number(), false);
        }
        display.key(key, recognizer.keys());
        conclude(recognition, call);
        listener.changed();
    }

    /** Speech of the call has come, lost frames included: the time-out of an order left unfinished is counted by it. */
    public void speech(long samples) {
        if (call != null && conclude(recognizer.elapsed(samples), call)) {
            listener.changed();
        }
    }

    /** A short message. @param from the number that the network vouches for */
    public void message(String from, String text) {
        if (!settings.permits(from)) {
            listener.senderIgnored(from);
            return;
        }
        display.begin(from, true);
        conclude(OrderText.read(text), OrderOrigin.message(from));
        listener.changed();
    }

    /** The robot's status has changed by itself; stop orders that waited for standstill are answered. */
    public void statusChanged() {
        if (running == null && held == null && robot.status() != RobotStatus.MOVING) {
            answerStops();
        }
        listener.changed();
    }

    /** Whether an order is being executed. */
    public boolean isUnderWay() {
        return running != null || held != null || !stops.isEmpty();
    }

    /** What a window shows, immutable. */
    public VeriCommandSnapshot snapshot() {
        return display.snapshot(call != null, isUnderWay());
    }

    private boolean conclude(Recognition recognition, OrderOrigin source) {
        if (recognition instanceof Recognition.Pending) {
            return false;
        }
        if (recognition instanceof Recognition.Complete complete && endsAutonomy(complete.order())) {
            hold(complete, source);
        } else {
            judge(recognition, source);
        }
        return true;
    }

    /** Who asks only for the status disturbs nobody. */
    private boolean endsAutonomy(Order order) {
        return robot.isAutonomous() && (order.moves() || order.stops());
    }

    private void hold(Recognition.Complete complete, OrderOrigin source) {
        held = new HeldOrder(complete, source);
        tellUnderWay();
        robot.endAutonomy(this::judgeHeld);
    }

    private void judgeHeld() {
        HeldOrder over = held;
        held = null;
        if (over.isStopOrdered()) {
            stopHeld(over);
        } else if (!over.source().isGone()) {
            judge(over.recognition(), over.source());
        }
        answerStops();
        tellUnderWay();
        listener.changed();
    }

    /** What kept it from moving has been ordered after it. */
    private void stopHeld(HeldOrder over) {
        Verdict verdict = Verdict.of(over.recognition(), robot.status());
        display.verdict(verdict);
        listener.order(verdict.keys(), verdict);
        over.firstProgress().ifPresent(progress -> answer(over.source(), texts.stopped(progress), false));
    }

    private void judge(Recognition recognition, OrderOrigin source) {
        Verdict verdict = Verdict.of(recognition, robot.status());
        display.verdict(verdict);
        listener.order(verdict.keys(), verdict);
        if (verdict instanceof Verdict.Invalid invalid) {
            answer(source, texts.invalid(invalid.fault()));
        } else if (verdict instanceof Verdict.Refused refused) {
            answer(source, texts.refused(refused.tone(), refused.status()));
        } else {
            begin(new OrderExecution(((Verdict.Accepted) verdict).order(), source));
        }
    }

    private void begin(OrderExecution execution) {
        if (execution.order().moves()) {
            running = execution;
            tellUnderWay();
            proceed();
        } else if (!execution.order().stops()) {
            endInstructions(execution);
            answer(execution.source(), texts.report(execution.order(), robot.status(), robot.pose()));
        } else {
            stops.add(execution);
            tellUnderWay();
            if (robot.status() == RobotStatus.MOVING) {
                stopRobot();
            } else {
                answerStops();
            }
        }
    }

    private void stopRobot() {
        if (running != null) {
            running.orderStop();
        }
        if (held != null) {
            held.orderStop();
        }
        robot.brake();
    }

    /** Instruction after instruction, until one needs time, is refused or none is left. */
    private void proceed() {
        while (!running.isComplete()) {
            Instruction present = running.present();
            StatusRules.Treatment treatment = StatusRules.treatment(robot.status(), present);
            if (treatment != StatusRules.Treatment.EXECUTED) {
                int of = running.order().instructions().size();
                end(texts.refusedAfter(treatment.tone(), robot.status(), running.done(), of));
                return;
            }
            if (present instanceof Instruction.Motion motion) {
                start(motion);
                return;
            }
            running.presentIsDone();
            listener.instructionEnded(present);
        }
        end(texts.done(running.order(), robot.status(), robot.pose()));
    }

    private void start(Instruction.Motion motion) {
        if (running.announce() && !running.source().isMessage()) {
            listener.tone(ReplyTone.EXECUTING);
        }
        robot.start(motion, this::motionEnded);
    }

    private void motionEnded(MotionOutcome outcome) {
        listener.instructionEnded(running.present());
        OrderProgress progress = running.progress(outcome.amountDone());
        switch (outcome.ending()) {
            case DONE -> motionDone(progress);
            case BRAKED -> end(texts.stopped(progress));
            case COLLISION -> end(texts.failed(ReplyTone.COLLISION, progress));
            case INFINITE_LOOP -> end(texts.failed(ReplyTone.INFINITE_LOOP, progress));
            case ABORTED -> end(texts.aborted(progress, robot.status()));
        }
    }

    private void motionDone(OrderProgress progress) {
        running.presentIsDone();
        if (running.endsHere() && !running.isComplete()) {
            end(texts.stopped(progress));
        } else {
            proceed();
        }
    }

    private void end(Reply reply) {
        OrderExecution ended = running;
        running = null;
        answer(ended.source(), reply, !ended.isStopOrdered() || ended.isComplete());
        answerStops();
        tellUnderWay();
        listener.changed();
    }

    private void answerStops() {
        List<OrderExecution> standing = List.copyOf(stops);
        stops.clear();
        for (OrderExecution stop : standing) {
            endInstructions(stop);
            RobotStatus status = robot.status();
            answer(
                    stop.source(),
                    status == RobotStatus.DISCONNECTED
                            ? texts.refused(ReplyTone.CONNECTION_DENIED, status)
                            : texts.done(stop.order(), status, robot.pose()));
        }
        tellUnderWay();
    }

    private void endInstructions(OrderExecution execution) {
        execution.order().instructions().forEach(listener::instructionEnded);
    }

    private void answer(OrderOrigin source, Reply reply) {
        answer(source, reply, true);
    }

    /** @param byTone whether a call hears the answer; an order that {@code ###} kept from its goal has no tone */
    private void answer(OrderOrigin source, Reply reply, boolean byTone) {
        if (source.isGone()) {
            return;
        }
        display.reply(reply);
        listener.outcome(reply);
        if (source.isMessage()) {
            listener.message(source.number(), reply.message());
        } else if (byTone) {
            listener.tone(reply.tone());
            if (reply.tone() == ReplyTone.CONNECTION_DENIED) {
                listener.clearCall();
            }
        }
    }

    private void tellUnderWay() {
        if (toldUnderWay != isUnderWay()) {
            toldUnderWay = isUnderWay();
            listener.underWay(toldUnderWay);
        }
    }
}
