package simrobot.control;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import simrobot.process.BehaviourKind;
import simrobot.process.Decision;
import simrobot.robot.Pioneer;
import vericommand.Instruction;
import vericommand.OrderReport;
import vericommand.ProcessEnding;
import vericommand.Reply;
import vericommand.ReplyTone;
import vericommand.RobotStatus;
import vericommand.Verdict;
import vericommand.VeriCommand;
import vericommand.VeriCommandListener;
import vericommand.VeriCommandSettings;
import vericommand.VeriCommandSnapshot;

/**
 * One robot with its verifier, driven by its modem's events. Owned by the simulation's thread, so that the status
 * cannot change between check and action; only {@link #admission} and {@link #snapshot} are thread-safe.
 */
final class RobotControl {
    private static final Logger LOG = System.getLogger(RobotControl.class.getName());

    private final Pioneer robot;
    private final VeriCommandSettings settings;
    private final ModemPort modem;
    private final LongSupplier clockNanos;
    private final List<Consumer<RobotEvent>> listeners = new CopyOnWriteArrayList<>();
    private final OrderLatencyLog stopwatch;
    private final VeriCommand veriCommand;
    private long callNumber;
    private boolean isBatteryLow;
    private volatile RobotStatus status;
    private volatile VeriCommandSnapshot snapshot;

    RobotControl(Pioneer robot, VeriCommandSettings settings, ModemPort modem, LongSupplier clockNanos) {
        this.robot = robot;
        this.settings = settings;
        this.modem = modem;
        this.clockNanos = clockNanos;
        stopwatch = new OrderLatencyLog(robot.name(), clockNanos);
        veriCommand = new VeriCommand(robot, settings, new Answers());
        status = robot.status();
        snapshot = veriCommand.snapshot();
        robot.addStatusListener(this::statusChanged);
        robot.addFirstMotionListener(stopwatch::wheelsMoved);
        robot.autonomy().addListener(kind -> tell(new RobotEvent.BehaviourChanged(kind)));
        robot.autonomy().addEndListener(this::processEnded);
        ProcessTelephone telephone = new ProcessTelephone(modem, () -> callNumber, clockNanos, this::tell);
        robot.autonomy().addRequestListener((kind, asked) -> telephone.perform(kind.text(), asked));
    }

    /** Returns the first tone for a caller by the current status; callable on any thread. */
    ReplyTone admission(String caller) {
        return settings.admission(caller, status);
    }

    /** Returns the state for a window; callable on any thread. */
    VeriCommandSnapshot snapshot() {
        return snapshot;
    }

    Pioneer robot() {
        return robot;
    }

    /** Adds a listener, called on the simulation's thread; add it before the first event. */
    void listen(Consumer<RobotEvent> listener) {
        listeners.add(listener);
    }

    /** Passes an event to all listeners in the order of their registration. */
    void tell(RobotEvent event) {
        listeners.forEach(listener -> listener.accept(event));
    }

    /** @param call number of the call; late replies carry it */
    void callBegan(long call, String caller) {
        callNumber = call;
        robot.autonomy().call().begin(caller);
        veriCommand.callBegan(caller);
        modem.setOrderUnderWay(veriCommand.isUnderWay());
    }

    /** @param beganNanos when the key's tone began in the received audio, by the clock of this control */
    void key(char key, long beganNanos) {
        tell(new RobotEvent.KeyReceived(key));
        stopwatch.keyBegan(beganNanos);
        veriCommand.key(key);
        stopwatch.noKey();
    }

    /** The newest key was released. */
    void keyEnded() {
        robot.autonomy().call().release();
    }

    void speech(long samples) {
        veriCommand.speech(samples);
    }

    /** The modem clears the call after 60 s without a key; {@link #callEnded} follows. */
    void callIdle(int seconds) {
        LOG.log(Level.INFO, robot.name() + ": the call is ended, no key has come for " + seconds + " s");
        tell(new RobotEvent.CallIdle(seconds));
        veriCommand.callIdle(seconds);
    }

    void callEnded(int cause) {
        tell(new RobotEvent.CallReleased(cause));
        robot.autonomy().call().release();
        veriCommand.callEnded();
    }

    void message(String from, String text) {
        tell(new RobotEvent.MessageReceived(from, text));
        veriCommand.message(from, text, clockNanos.getAsLong());
    }

    /** Submits an order of a program; see {@link VeriCommand#order}. */
    void order(String operator, String text, Consumer<OrderReport> follower) {
        tell(new RobotEvent.OrderSubmitted(operator, text));
        veriCommand.order(operator, text, follower);
    }

    /**
     * Answers a USSD request of the network.
     *
     * @return the verifier's reply
     */
    String question(String text) {
        String reply = veriCommand.query(text);
        tell(new RobotEvent.UssdAnswered(text, reply));
        return reply;
    }

    private void statusChanged(RobotStatus now) {
        status = now;
        tell(new RobotEvent.StatusChanged(now));
        if (isBatteryLow != robot.hasLowBattery()) {
            isBatteryLow = !isBatteryLow;
            tell(new RobotEvent.BatteryChanged(isBatteryLow));
        }
        if (now == RobotStatus.NO_MOTORS) {
            robot.unknownType().ifPresent(type -> tell(new RobotEvent.TypeUnknown(type)));
        }
        veriCommand.statusChanged();
    }

    private void processEnded(BehaviourKind kind, Decision.End how) {
        ProcessEnding ending = ProcessEnding.REPLACED;
        String why = "";
        if (how instanceof Decision.Done || how instanceof Decision.Arrived) {
            ending = ProcessEnding.DONE;
        } else if (how instanceof Decision.Collided) {
            ending = ProcessEnding.COLLISION;
        } else if (how instanceof Decision.GivenUp givenUp) {
            ending = ProcessEnding.FAILED;
            why = givenUp.text();
        } else if (how instanceof Decision.Failed failed) {
            ending = ProcessEnding.FAILED;
            why = failed.where() + failed.text();
            tell(new RobotEvent.BehaviourFailed(kind.text(), failed.line(), failed.text()));
        }
        if (how instanceof Decision.Arrived) {
            tell(new RobotEvent.Arrived(robot.pose()));
        }
        veriCommand.processEnded(ending, kind.text(), why);
    }

    private final class Answers implements VeriCommandListener {
        @Override
        public void tone(ReplyTone tone) {
            modem.sendTone(callNumber, tone.key());
        }

        @Override
        public void answer(Reply reply) {
            tone(reply.tone());
            modem.say(callNumber, reply.text());
        }

        @Override
        public boolean listen() {
            return modem.listen(callNumber);
        }

        @Override
        public void clearCall() {
            modem.clearCall(callNumber);
        }

        @Override
        public void message(String to, String text) {
            if (modem.sendMessage(to, text)) {
                tell(new RobotEvent.ReplySent(to, text));
            }
        }

        @Override
        public void underWay(boolean underWay) {
            modem.setOrderUnderWay(underWay);
            if (!underWay) {
                stopwatch.orderEnded();
            }
        }

        @Override
        public void order(String keys, Verdict verdict) {
            stopwatch.order(verdict);
            tell(new RobotEvent.OrderVerified(verdict.keys(), verdict.word()));
        }

        @Override
        public void instructionEnded(Instruction instruction) {
            tell(new RobotEvent.PoseReported(robot.pose()));
        }

        @Override
        public void outcome(Reply reply) {
            tell(new RobotEvent.OrderAnswered(reply.tone().number(), reply.text()));
        }

        @Override
        public void senderIgnored(String from) {
            LOG.log(Level.INFO, robot.name() + ": SMS from " + from + " ignored: no operator, or no order");
        }

        @Override
        public void replyIgnored(String from) {
            LOG.log(Level.INFO, robot.name() + ": SMS from " + from + " ignored, it is a robot's reply");
        }

        @Override
        public void senderSilenced(String from) {
            LOG.log(
                    Level.WARNING,
                    robot.name() + ": too many SMS without a valid order from " + from
                            + ", for a minute such ones get no reply");
        }

        @Override
        public void changed() {
            snapshot = veriCommand.snapshot();
        }
    }
}
