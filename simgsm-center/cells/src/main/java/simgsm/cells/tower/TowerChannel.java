package simgsm.cells.tower;

import java.util.Optional;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.Cause;
import simgsm.air.ChannelNumber;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Type;
import simgsm.air.MeasurementResults;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.air.RadioResource.MeasurementReport;
import simgsm.air.RadioResource.PhysicalInformation;
import simgsm.cells.capture.ChannelCapture;
import simgsm.cells.cipher.CipherKey;
import simgsm.octets.OctetString;
import simgsm.timer.Timers;

/** An active dedicated channel of a tower: its link layer, measurements and speech. */
public final class TowerChannel {
    private static final int SIGNALLING = 0;
    private static final int SHORT_MESSAGES = 3;
    /** Bit in a link identifier for the slow associated channel, which carries short messages during speech. */
    private static final int SLOW_ASSOCIATED = 0x40;

    private static final int RADIO_LINK_FAILURE = 0x01;
    /** Activation types (TS 48.058, 9.3.3) of a handover. */
    private static final int HANDOVER_ASYNCHRONOUS = 2;

    private static final int HANDOVER_SYNCHRONOUS = 3;
    /** Period of PHYSICAL INFORMATION, T3105, 20 ms here; sent at most NY1 times. */
    private static final long T3105_NANOS = 20_000_000;

    private static final int NY1 = 10;
    private static final int NUMBERS = 256;
    /** Mask of the MS power octet (TS 48.058, 9.3.13). */
    private static final int POWER_LEVEL_MASK = 0x1f;

    private final BaseStation tower;
    private final Timers timers;
    private final ChannelNumber number;
    private final int activation;
    private final Optional<Integer> handoverReference;
    /** Null without a mobile. */
    private ChannelUser user;

    private boolean isEstablished;
    private boolean hasShortMessages;
    private boolean isReporting = true;
    private int orderedPowerLevel;
    private int measurement;
    private final TowerSpeech speech;
    private final ChannelCapture capture;
    private CipherKey key = CipherKey.NONE;
    /** Replaces the key with the mobile's answer, the first message under it. */
    private CipherKey commandedKey = CipherKey.NONE;

    private final ConnectHold hold;
    private boolean isClosed;

    TowerChannel(BaseStation tower, Timers timers, RslPdu activated) throws ProtocolViolation {
        this.tower = tower;
        this.timers = timers;
        number = activated.channel();
        capture = tower.capture().channel(number);
        activation = activated.octet(RslElement.ACTIVATION_TYPE) & 0x07;
        orderedPowerLevel = powerLevel(activated).orElse(0);
        speech = new TowerSpeech(tower, number, timers, this::speechReceived);
        if (activated.has(RslElement.ENCRYPTION_INFORMATION)) {
            key = tower.cipherKey(activated);
            commandedKey = key;
            capture.cipher(true, key);
            capture.cipher(false, key);
        }
        hold = new ConnectHold(timers, layer3 -> indicate(SIGNALLING, layer3));
        handoverReference = activated.find(RslElement.HANDOVER_REFERENCE).map(value -> value.octet(0));
    }

    private static Optional<Integer> powerLevel(RslPdu message) {
        return message.find(RslElement.MS_POWER).map(value -> value.octet(0) & POWER_LEVEL_MASK);
    }

    /** The ordered power control level; 0, the largest output, without an order. */
    public int orderedPowerLevel() {
        return orderedPowerLevel;
    }

    public ChannelNumber number() {
        return number;
    }

    public BaseStation tower() {
        return tower;
    }

    public boolean isTraffic() {
        return number.kind().isSpeech();
    }

    /** False once the channel is released or its tower is off. */
    public boolean isActive() {
        return !isClosed;
    }

    /** True if a mobile may enter the channel: it is active, and has no mobile. */
    public boolean isAwaiting() {
        return user == null && !isClosed;
    }

    /** True if a mobile handed over to this channel knows its timing advance. */
    public boolean isSynchronised() {
        return activation == HANDOVER_SYNCHRONOUS;
    }

    /** True while the air is ciphered. */
    public boolean isCiphered() {
        return key.isCiphering();
    }

    /** True if the tower can read what is ciphered with this key. */
    public boolean reads(CipherKey used) {
        return used.equals(key) || used.equals(commandedKey);
    }

    // From the controller.

    void arrived(RslPdu message) throws ProtocolViolation {
        switch (message.type()) {
            case DATA_REQUEST, UNIT_DATA_REQUEST -> sendDown(message.sapi(), message.value(RslElement.L3_INFORMATION));
            case ESTABLISH_REQUEST -> establishRequested(message);
            case RELEASE_REQUEST -> {
                if (message.sapi() == SHORT_MESSAGES) {
                    hasShortMessages = false;
                } else {
                    isEstablished = false;
                }
                tower.send(RslPdu.of(RslType.RELEASE_CONFIRM, number, message.octet(RslElement.LINK_IDENTIFIER)));
            }
            case DEACTIVATE_SACCH -> isReporting = false;
            case RF_CHANNEL_RELEASE -> {
                tower.released(this);
                close();
            }
            case MODE_MODIFY_REQUEST -> tower.send(RslPdu.of(RslType.MODE_MODIFY_ACKNOWLEDGE, number));
            case MS_POWER_CONTROL -> orderedPowerLevel = powerLevel(message).orElse(orderedPowerLevel);
            case BS_POWER_CONTROL, MEASUREMENT_PREPROCESSING_DEFAULTS -> {}
            case CREATE_CONNECTION -> speech.create(message);
            case MODIFY_CONNECTION -> speech.modify(message, hold::speechConnected);
            case DELETE_CONNECTION -> speech.delete();
            case ENCRYPTION_COMMAND -> commandCiphering(message);
            default ->
                throw new ProtocolViolation(
                        Cause.MESSAGE_TYPE_NON_EXISTENT, message.type().title() + " is not for a tower");
        }
    }

    private void commandCiphering(RslPdu message) throws ProtocolViolation {
        CipherKey commanded = tower.cipherKey(message);
        OctetString layer3 = message.value(RslElement.L3_INFORMATION);
        commandedKey = commanded;
        sendDown(SIGNALLING, layer3);
    }

    private void sendDown(int sapi, OctetString layer3) {
        if (user != null) {
            capture.message(false, sapi, layer3);
            user.layer3Arrived(this, sapi, layer3);
        }
    }

    private void establishRequested(RslPdu message) throws ProtocolViolation {
        int link = message.octet(RslElement.LINK_IDENTIFIER);
        if (user != null) {
            hasShortMessages |= message.sapi() == SHORT_MESSAGES;
            tower.send(RslPdu.of(RslType.ESTABLISH_CONFIRM, number, link));
        }
    }

    private void speechReceived(byte[] rtp) {
        if (user != null && isEstablished) {
            user.speechArrived(this, rtp);
        }
    }

    /** Ends the channel. */
    void close() {
        isClosed = true;
        hold.drain();
        speech.close();
        ChannelUser last = user;
        user = null;
        if (last != null) {
            last.channelLost(this);
        }
    }

    // From the mobile.

    /**
     * Handles a mobile's SABM; no tower receives it if the channel is released.
     *
     * @param layer3 null for none
     */
    public void establish(ChannelUser newUser, OctetString layer3) {
        if (isClosed) {
            return;
        }
        user = newUser;
        isEstablished = true;
        capture.establish(layer3);
        RslPdu indication = RslPdu.of(RslType.ESTABLISH_INDICATION, number, SIGNALLING);
        tower.send(layer3 == null ? indication : indication.with(RslElement.L3_INFORMATION, layer3));
    }

    /**
     * Sends a message of the mobile; its first short message first establishes the link. CONNECT may be held
     * temporarily.
     */
    public void send(int sapi, OctetString layer3) {
        if (isClosed) {
            return;
        }
        boolean isComplete = user != null && sapi == SIGNALLING && isCipheringComplete(layer3);
        if (isComplete) {
            if (!user.key().equals(commandedKey)) {
                return;
            }
            key = commandedKey;
            capture.cipher(true, key);
        }
        capture.message(true, sapi, layer3);
        if (isComplete) {
            capture.cipher(false, key);
            user.ciphered(key.algorithm());
        }
        if (sapi == SIGNALLING) {
            hold.send(layer3);
        } else {
            indicate(sapi, layer3);
        }
    }

    private static boolean isCipheringComplete(OctetString layer3) {
        return layer3.length() > 1
                && layer3.octet(0) == Layer3Header.RADIO_RESOURCE
                && layer3.octet(1) == Layer3Type.CIPHERING_MODE_COMPLETE.code();
    }

    /** Sends the messages held by another channel of the same mobile. */
    public void sendHeldBy(TowerChannel old) {
        old.hold.drain().forEach(hold::send);
    }

    private void indicate(int sapi, OctetString layer3) {
        int link = sapi == SHORT_MESSAGES && isTraffic() ? SLOW_ASSOCIATED | sapi : sapi;
        if (sapi == SHORT_MESSAGES && !hasShortMessages) {
            hasShortMessages = true;
            tower.send(RslPdu.of(RslType.ESTABLISH_INDICATION, number, link));
        }
        tower.send(RslPdu.of(RslType.DATA_INDICATION, number, link).with(RslElement.L3_INFORMATION, layer3));
    }

    /** Ends the mobile's use of the channel with DISC. */
    public void leave() {
        hold.drain();
        if (user != null) {
            capture.release();
            user = null;
            if (isEstablished && !isClosed) {
                tower.send(RslPdu.of(RslType.RELEASE_INDICATION, number, SIGNALLING));
            }
        }
    }

    /** Ends the mobile's use of the channel without a message, after its move or the loss of its signal. */
    public void forsake(boolean isReported) {
        if (user != null && isReported && !isClosed) {
            tower.send(RslPdu.of(RslType.CONNECTION_FAILURE, number).with(RslElement.CAUSE, RADIO_LINK_FAILURE));
        }
        user = null;
    }

    /**
     * Handles HANDOVER ACCESS of a mobile.
     *
     * @return true if the reference is the channel's
     */
    public boolean handoverAccess(ChannelUser newUser, int reference, int timingAdvance) {
        boolean isAwaited =
                !isClosed && handoverReference.isPresent() && handoverReference.get() == reference && user == null;
        if (isAwaited) {
            user = newUser;
            tower.send(RslPdu.of(RslType.HANDOVER_DETECTION, number).with(RslElement.ACCESS_DELAY, timingAdvance));
            if (activation == HANDOVER_ASYNCHRONOUS) {
                sendPhysicalInformation(timingAdvance, 1);
            }
        }
        return isAwaited;
    }

    private void sendPhysicalInformation(int timingAdvance, int count) {
        timers.start(T3105_NANOS, () -> {
            if (user != null && !isEstablished && !isClosed) {
                capture.unacknowledged(encoded(new PhysicalInformation(timingAdvance), Direction.DOWNLINK));
                user.physicalInformation(this, timingAdvance);
                if (count < NY1) {
                    sendPhysicalInformation(timingAdvance, count + 1);
                }
            }
        });
    }

    /**
     * Reports the measurements of tower and mobile in 480 ms.
     *
     * @param uplinkLevel RXLEV;
     * @param uplinkQuality RXQUAL;
     * @param powerLevel of the mobile
     * @param report the mobile's; empty if its block was lost
     * @return the number of the report; -1 if the channel no longer reports
     */
    public int measured(
            int uplinkLevel,
            int uplinkQuality,
            int powerLevel,
            int timingAdvance,
            Optional<MeasurementResults> report) {
        if (!isReporting || isClosed) {
            return -1;
        }
        int now = measurement;
        measurement = (measurement + 1) % NUMBERS;
        RslPdu result = RslPdu.of(RslType.MEASUREMENT_RESULT, number)
                .with(RslElement.MEASUREMENT_RESULT_NUMBER, now)
                .with(RslElement.UPLINK_MEASUREMENTS, OctetString.of(new byte[] {
                    (byte) uplinkLevel, (byte) uplinkLevel, (byte) (uplinkQuality << 3 | uplinkQuality)
                }))
                .with(RslElement.BS_POWER, 0)
                .with(RslElement.L1_INFORMATION, powerLevel << 3, timingAdvance);
        Optional<OctetString> layer3 = report.map(results -> encoded(new MeasurementReport(results), Direction.UPLINK));
        capture.measured(powerLevel, timingAdvance, layer3);
        tower.send(layer3.map(octets -> result.with(RslElement.L3_INFORMATION, octets))
                .orElse(result));
        return now;
    }

    private static OctetString encoded(RadioResource message, Direction direction) {
        return OctetString.of(Layer3Codec.encode(message, direction, 0));
    }

    /** Sends an RTP packet with the mobile's speech. */
    public void sendSpeech(byte[] rtp) {
        if (isEstablished) {
            speech.send(rtp);
        }
    }

    @Override
    public String toString() {
        return tower + ", " + number;
    }
}
