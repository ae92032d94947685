package simgsm.cells.tower;

import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ChannelNumber;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.MeasurementResults;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.MeasurementReport;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.timer.RateLimit;
import simgsm.timer.Timers;

/** An active dedicated channel of a tower: its link layer, measurements and speech. */
public final class TowerChannel {
    /** Radio channel already activated (TS 48.058, 9.3.26). */
    static final int CAUSE_CHANNEL_ACTIVATED = 0x05;

    private static final System.Logger LOG = System.getLogger(TowerChannel.class.getName());
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
    private static final int RTP_GSM = 3;
    /** Mask of the MS power octet (TS 48.058, 9.3.13). */
    private static final int POWER_LEVEL_MASK = 0x1f;

    /** Maximum rate of the controller's packets: twice the rate of a call; more are dropped. */
    private static final int SPEECH_PER_SECOND = 100;
    /** Burst after a stall of 4 s. */
    private static final int SPEECH_AT_ONCE = 200;

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
    private int connection;
    /** Null without a speech connection. */
    private SpeechSocket speech;

    private final ConnectHold hold;
    private final RateLimit speechRate = new RateLimit(SPEECH_PER_SECOND, SPEECH_AT_ONCE);
    private boolean isClosed;

    TowerChannel(BaseStation tower, Timers timers, RslPdu activated) throws ProtocolViolation {
        this.tower = tower;
        this.timers = timers;
        number = activated.channel();
        activation = activated.octet(RslElement.ACTIVATION_TYPE) & 0x07;
        orderedPowerLevel = powerLevel(activated).orElse(0);
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

    // From the controller.

    void arrived(RslPdu message) throws ProtocolViolation {
        switch (message.type()) {
            case DATA_REQUEST, UNIT_DATA_REQUEST -> {
                if (user != null) {
                    user.layer3Arrived(this, message.sapi(), message.value(RslElement.L3_INFORMATION));
                }
            }
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
            case CREATE_CONNECTION -> createConnection(message);
            case MODIFY_CONNECTION -> modifyConnection(message);
            case DELETE_CONNECTION -> {
                closeSpeech();
                tower.send(RslPdu.of(RslType.DELETE_CONNECTION_ACKNOWLEDGE, number)
                        .with(RslElement.CONNECTION_IDENTIFIER, connectionOctets()));
            }
            default ->
                LOG.log(Level.DEBUG, "{0}: {1} ignored", this, message.type().title());
        }
    }

    private void establishRequested(RslPdu message) throws ProtocolViolation {
        int link = message.octet(RslElement.LINK_IDENTIFIER);
        if (user != null) {
            hasShortMessages |= message.sapi() == SHORT_MESSAGES;
            tower.send(RslPdu.of(RslType.ESTABLISH_CONFIRM, number, link));
        }
    }

    private void createConnection(RslPdu message) {
        closeSpeech();
        if (tower.port() == null) {
            return;
        }
        Optional<SpeechSocket> opened = tower.port().openSpeech(this::speechReceived);
        // the elements for addresses support only IPv4
        if (opened.isEmpty() || opened.get().address().host().contains(":")) {
            opened.ifPresent(SpeechSocket::close);
            tower.send(RslPdu.of(RslType.CREATE_CONNECTION_NEGATIVE_ACKNOWLEDGE, number)
                    .with(RslElement.CAUSE, 0x2f));
            return;
        }
        speech = opened.get();
        connection++;
        connect(message);
        tower.send(connected(RslType.CREATE_CONNECTION_ACKNOWLEDGE));
    }

    private void modifyConnection(RslPdu message) {
        if (speech == null || !connect(message)) {
            tower.send(RslPdu.of(RslType.MODIFY_CONNECTION_NEGATIVE_ACKNOWLEDGE, number)
                    .with(RslElement.CONNECTION_IDENTIFIER, connectionOctets())
                    .with(RslElement.CAUSE, 0x2f));
        } else {
            hold.speechConnected();
            tower.send(connected(RslType.MODIFY_CONNECTION_ACKNOWLEDGE));
        }
    }

    /** Connects to the address in the message, if there is one. */
    private boolean connect(RslPdu message) {
        if (!message.has(RslElement.REMOTE_IP) || !message.has(RslElement.REMOTE_PORT)) {
            return true;
        }
        OctetString port = message.find(RslElement.REMOTE_PORT).orElseThrow();
        try {
            String host = InetAddress.getByAddress(
                            message.find(RslElement.REMOTE_IP).orElseThrow().toArray())
                    .getHostAddress();
            return speech.connect(new MediaAddress(host, port.octet(0) << 8 | port.octet(1)));
        } catch (UnknownHostException e) {
            return false;
        }
    }

    private RslPdu connected(RslType type) {
        MediaAddress own = speech.address();
        OctetWriter host = new OctetWriter();
        for (String part : own.host().split("\\.")) {
            host.octet(Integer.parseInt(part));
        }
        return RslPdu.of(type, number)
                .with(RslElement.CONNECTION_IDENTIFIER, connectionOctets())
                .with(RslElement.LOCAL_IP, host.toOctetString())
                .with(RslElement.LOCAL_PORT, own.port() >> 8, own.port())
                .with(RslElement.RTP_PAYLOAD_2, RTP_GSM);
    }

    private OctetString connectionOctets() {
        return new OctetWriter().twoOctets(connection).toOctetString();
    }

    private void speechReceived(byte[] rtp) {
        if (user != null && isEstablished && speechRate.take(timers.nowNanos())) {
            user.speechArrived(this, rtp);
        }
    }

    private void closeSpeech() {
        if (speech != null) {
            speech.close();
            speech = null;
        }
    }

    /** Ends the channel. */
    void close() {
        isClosed = true;
        hold.drain();
        closeSpeech();
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
        RslPdu indication = RslPdu.of(RslType.ESTABLISH_INDICATION, number, SIGNALLING);
        tower.send(layer3 == null ? indication : indication.with(RslElement.L3_INFORMATION, layer3));
    }

    /**
     * Sends a message of the mobile; its first short message first establishes the link. CONNECT may be held
     * temporarily.
     */
    public void send(int sapi, OctetString layer3) {
        if (!isClosed && sapi == SIGNALLING) {
            hold.send(layer3);
        } else if (!isClosed) {
            indicate(sapi, layer3);
        }
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
        tower.send(
                report.isEmpty()
                        ? result
                        : result.with(
                                RslElement.L3_INFORMATION,
                                OctetString.of(
                                        Layer3Codec.encode(new MeasurementReport(report.get()), Direction.UPLINK, 0))));
        return now;
    }

    /** Sends an RTP packet with the mobile's speech. */
    public void sendSpeech(byte[] rtp) {
        if (speech != null && isEstablished) {
            speech.send(rtp);
        }
    }

    @Override
    public String toString() {
        return tower + ", " + number;
    }
}
