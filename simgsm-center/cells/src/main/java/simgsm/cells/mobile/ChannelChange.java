package simgsm.cells.mobile;

import java.util.Optional;
import java.util.OptionalInt;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Message;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.air.RadioResource.AssignmentCommand;
import simgsm.air.RadioResource.CellDescription;
import simgsm.air.RadioResource.ChannelModeModify;
import simgsm.air.RadioResource.HandoverCommand;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioEvent;
import simgsm.cells.snapshot.PassingStep;
import simgsm.cells.tower.TowerChannel;
import simgsm.octets.OctetString;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** Moves the mobile from one channel to another: assignment (TS 44.018, 3.4.3) and handover (3.4.4). */
final class ChannelChange {
    /** Time to tune to the new channel and set up its link layer. */
    private static final long TUNING_NANOS = 40_000_000;
    /** Period of HANDOVER ACCESS (TS 44.018, 3.4.4.2.2.1): one burst in each TDMA frame. */
    private static final long ACCESS_NANOS = 120_000_000 / 26;
    /** SABM on the new channel takes the place of one speech frame. */
    private static final long ARRIVAL_NANOS = 20_000_000;

    private static final long T3124_NANOS = 320_000_000;
    /** HANDOVER ACCESS bursts in a synchronised cell. */
    private static final int SYNCHRONISED_ACCESSES = 4;

    // RR causes (TS 44.018, 10.5.2.31).
    private static final int TIMER_EXPIRED = 3;
    private static final int MODE_UNACCEPTABLE = 9;
    private static final int FREQUENCY_NOT_IMPLEMENTED = 10;
    private static final int UNSPECIFIED = 0x6f;

    private final Mobile mobile;
    private final MobileNetwork network;
    private final Timers timers;
    private AssignmentCommand assignment;
    private HandoverCommand handover;
    /** Null before the mobile has reached it. */
    private TowerChannel target;

    private int targetTower = IdleSelection.NONE;
    /** Mode of the current channel. */
    private int mode;

    private int cause;
    private Timer next;
    private Timer limit;

    ChannelChange(Mobile mobile, MobileNetwork network, Timers timers) {
        this.mobile = mobile;
        this.network = network;
        this.timers = timers;
    }

    /** Enters the first channel. */
    void begin() {
        mode = RadioResource.SIGNALLING_ONLY;
    }

    /** True for signalling and GSM 06.10, the modes of terminals. */
    private static boolean isSupported(int channelMode) {
        return channelMode == RadioResource.SIGNALLING_ONLY || channelMode == RadioResource.SPEECH_FULL_RATE;
    }

    static OctetString encoded(RadioResource message) {
        Direction direction = message instanceof RadioResource.ChannelRelease ? Direction.DOWNLINK : Direction.UPLINK;
        return OctetString.of(Layer3Codec.encode(message, direction, 0));
    }

    /**
     * Handles a message for the radio part only.
     *
     * @return true if it is one
     */
    boolean takes(OctetString layer3) {
        if (layer3.length() < 2 || layer3.octet(0) != Layer3Header.RADIO_RESOURCE) {
            return false;
        }
        Layer3Message message;
        try {
            message = Layer3Codec.decode(layer3.toArray(), Direction.DOWNLINK);
        } catch (ProtocolViolation unknown) {
            return false;
        }
        if (message instanceof AssignmentCommand command) {
            assignment = command;
            mobile.fire(MobileRadioEvent.ASSIGNMENT_COMMAND);
            return true;
        } else if (message instanceof HandoverCommand command) {
            handover = command;
            mobile.fire(MobileRadioEvent.HANDOVER_COMMAND);
            return true;
        } else if (message instanceof ChannelModeModify modify) {
            modifyMode(modify);
            return true;
        }
        return false;
    }

    /** Changes the mode; an unsupported one keeps the old mode (TS 44.018, 3.4.6.1.3). */
    private void modifyMode(ChannelModeModify modify) {
        if (isSupported(modify.mode())) {
            mode = modify.mode();
        }
        mobile.current().send(0, encoded(new RadioResource.ChannelModeModifyAcknowledge(modify.channel(), mode)));
    }

    // Assignment.

    void beginAssignment() {
        mobile.passed(PassingStep.Kind.ASSIGNMENT_COMMAND, mobile.cell(), "", 0);
        if (!isSupported(assignment.channelMode())) {
            cause = MODE_UNACCEPTABLE;
            mobile.fire(MobileRadioEvent.CHANGE_FAILED);
            return;
        }
        cause = UNSPECIFIED;
        next = timers.start(TUNING_NANOS, this::arriveByAssignment);
    }

    /** Checks only on arrival that the channel exists. */
    private void arriveByAssignment() {
        target = mobile.current()
                .tower()
                .channel(assignment.channel().channel())
                .filter(TowerChannel::isAwaiting)
                .orElse(null);
        mobile.fire(target == null ? MobileRadioEvent.CHANGE_FAILED : MobileRadioEvent.ARRIVED);
    }

    void completeAssignment() {
        TowerChannel old = mobile.current();
        old.forsake(false);
        mode = assignment.channelMode();
        mobile.take(target);
        target.establish(mobile.user(), null);
        target.send(0, encoded(new RadioResource.AssignmentComplete(RadioResource.NORMAL_EVENT)));
        target.sendHeldBy(old);
        mobile.passed(PassingStep.Kind.ASSIGNMENT_COMPLETE, mobile.cell(), "", 0);
        end();
    }

    void failAssignment() {
        mobile.current().send(0, encoded(new RadioResource.AssignmentFailure(cause)));
        end();
    }

    // Handover.

    void beginHandover() {
        CellDescription cell = handover.cell();
        OptionalInt found = network.find(cell);
        mobile.passed(
                PassingStep.Kind.HANDOVER_COMMAND,
                mobile.cell(),
                found.isPresent()
                        ? network.towers().get(found.getAsInt()).tower().name()
                        : "",
                handover.reference());
        if (!isSupported(handover.channelMode().orElse(mode))) {
            cause = MODE_UNACCEPTABLE;
            mobile.fire(MobileRadioEvent.CHANGE_FAILED);
            return;
        }
        if (found.isEmpty()) {
            cause = FREQUENCY_NOT_IMPLEMENTED;
            next = timers.start(TUNING_NANOS, () -> mobile.fire(MobileRadioEvent.CHANGE_FAILED));
            return;
        }
        mobile.speech().handoverBegan();
        targetTower = found.getAsInt();
        cause = TIMER_EXPIRED;
        limit = timers.start(T3124_NANOS, () -> mobile.fire(MobileRadioEvent.CHANGE_FAILED));
        next = timers.start(ACCESS_NANOS, () -> access(1));
    }

    /** Decides randomly if a block of the other tower reaches the mobile now. */
    private boolean isReceived() {
        return network.towers().get(targetTower).isInService() && mobile.link().receivesBlock(targetTower);
    }

    private String targetName() {
        return network.towers().get(targetTower).tower().name();
    }

    /** Sends HANDOVER ACCESS until PHYSICAL INFORMATION arrives; in a synchronised cell four times. */
    private void access(int count) {
        if (count == 1) {
            mobile.passed(PassingStep.Kind.HANDOVER_ACCESS, mobile.cell(), targetName(), handover.reference());
        }
        if (target == null && isReceived()) {
            Optional<TowerChannel> active =
                    network.towers().get(targetTower).channel(handover.channel().channel());
            if (active.isPresent()
                    && active.get()
                            .handoverAccess(mobile.user(), handover.reference(), mobile.timingAdvance(targetTower))) {
                target = active.get();
            }
        }
        if (target != null && target.isSynchronised()) {
            if (count >= SYNCHRONISED_ACCESSES) {
                arrive();
                return;
            }
        }
        next = timers.start(ACCESS_NANOS, () -> access(count + 1));
    }

    void physicalInformation(TowerChannel from, int timingAdvance) {
        if (from == target && handover != null && isReceived()) {
            mobile.passed(PassingStep.Kind.PHYSICAL_INFORMATION, mobile.cell(), targetName(), timingAdvance);
            arrive();
        }
    }

    private void arrive() {
        timers.cancel(next);
        timers.cancel(limit);
        next = timers.start(ARRIVAL_NANOS, () -> mobile.fire(MobileRadioEvent.ARRIVED));
    }

    void completeHandover() {
        String from = mobile.cell();
        TowerChannel old = mobile.current();
        old.forsake(false);
        mode = handover.channelMode().orElse(mode);
        mobile.take(target);
        target.establish(mobile.user(), null);
        target.send(0, encoded(new RadioResource.HandoverComplete(RadioResource.NORMAL_EVENT)));
        target.sendHeldBy(old);
        mobile.passed(PassingStep.Kind.HANDOVER_COMPLETE, from, mobile.cell(), 0);
        network.happened(
                new MobileEvent.HandedOver(mobile, from, mobile.cell(), MobileEvent.HandoverResult.SUCCESS, 0));
        end();
    }

    void failHandover() {
        String to = targetTower == IdleSelection.NONE ? "" : targetName();
        if (target != null) {
            target.forsake(false);
        }
        TowerChannel old = mobile.current();
        if (cause != MODE_UNACCEPTABLE) {
            old.establish(mobile.user(), null);
        }
        old.send(0, encoded(new RadioResource.HandoverFailure(cause)));
        mobile.passed(PassingStep.Kind.HANDOVER_FAILURE, mobile.cell(), to, cause);
        network.happened(
                new MobileEvent.HandedOver(mobile, mobile.cell(), to, MobileEvent.HandoverResult.FAILURE, cause));
        end();
    }

    /** Handles the release of a channel by the tower. */
    void lost(TowerChannel channel) {
        if (channel == target) {
            target = null;
            mobile.fire(MobileRadioEvent.CHANGE_FAILED);
        }
    }

    /** Ends the change. */
    void end() {
        timers.cancel(next);
        timers.cancel(limit);
        assignment = null;
        handover = null;
        target = null;
        targetTower = IdleSelection.NONE;
    }
}
