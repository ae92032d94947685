package simgsm.modem;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Random;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.abis.RslMessage.Sapi;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.ConnectAcknowledge;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.CallControl.Release;
import simgsm.air.CallControl.ReleaseComplete;
import simgsm.air.CallControl.Setup;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.Imei;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RejectCause;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.ShortMessageControl;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.TransactionIdentifier;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.octets.OctetString;
import simgsm.speech.SpeechCodec;
import simgsm.station.StationOptions;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.context.Uplink;
import simgsm.station.mobility.Sim;

/** A modem with a network and a caller played for it; time passes in speech frames. */
final class CalledModem implements Uplink {
    private static final long FRAME_NANOS = 20_000_000L;
    private static final TransactionIdentifier TRANSACTION = new TransactionIdentifier(0, false);
    static final Msisdn CALLER = new Msisdn("5550100");

    final Modem modem;
    final List<String> told = new ArrayList<>();
    final List<Layer3Message> sent = new ArrayList<>();
    /** What the caller hears, a key with its frame each. */
    final StringBuilder heardByCaller = new StringBuilder();

    final List<DtmfDigit> heardDigits = new ArrayList<>();
    private final DtmfGenerator mouth = new DtmfGenerator();
    private final DtmfReceiver ear = new DtmfReceiver(digit -> {
        heardByCaller.append(digit.key().symbol());
        heardDigits.add(digit);
    });
    private final SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();

    CallDecision decision = new CallDecision(true, DtmfKey.ONE);
    boolean callerSpeaks = true;
    Optional<RejectCause> refusal = Optional.empty();
    long speechTimeSamples;
    private final Queue<IpaFrame> onTheWay = new ArrayDeque<>();
    private boolean up;
    private int sequence;
    private long now = 5_000_000_000L;

    /** A modem that answers at once. */
    CalledModem() {
        this(0);
    }

    CalledModem(int answerAfterMillis) {
        modem = new Modem(
                StationIdentity.ofOpenNumber(new Msisdn("5550200"), new Imei("490154203237518"), "SimGSM modem"),
                Sim.WITHOUT_KEY,
                new ModemOptions(StationOptions.STANDARD, answerAfterMillis),
                this::decide,
                this::accept,
                new Random(1));
        modem.station().linkUp(this, now);
        ccm(new CcmMessage.IdentityRequest());
        deliver();
        call();
    }

    void call() {
        ear.reset();
        rsl(new RslMessage.PagingCommand(modem.station().identity().imsi()));
        deliver();
    }

    void press(String keys) {
        DtmfKey.sequence(keys).forEach(mouth::enqueue);
    }

    void callerHangsUp() {
        up = false;
        down(new Disconnect(TRANSACTION, Cause.NORMAL_CALL_CLEARING));
        deliver();
    }

    /** The link to the network is lost. */
    void lose() {
        up = false;
        onTheWay.clear();
        modem.station().linkDown(now);
    }

    void findAgain() {
        modem.station().linkUp(this, now);
        ccm(new CcmMessage.IdentityRequest());
        deliver();
    }

    long messagesSubmitted() {
        return sent.stream().filter(CpData.class::isInstance).count();
    }

    /** Speech goes both ways as long as the call is up. */
    void pass(long millis) {
        for (long frame = 0; frame < millis / 20; frame++) {
            if (up && callerSpeaks) {
                sayNextFrame();
            }
            deliver();
            now += FRAME_NANOS;
            modem.station().timePassed(now);
            deliver();
        }
    }

    private void sayNextFrame() {
        short[] samples = new short[160];
        mouth.read(samples);
        RtpPacket packet = new RtpPacket(RtpPacket.A_LAW, sequence++ & 0xffff, 0, 1, codec.encode(samples));
        frame(IpaFrame.SPEECH, packet.encode());
    }

    private void down(Layer3Message message) {
        OctetString octets = OctetString.of(Layer3Codec.encode(message, Direction.DOWNLINK, 0));
        rsl(new RslMessage.DataRequest(
                message instanceof ShortMessageControl ? Sapi.SHORT_MESSAGES : Sapi.SIGNALLING, octets));
    }

    private void rsl(RslMessage message) {
        frame(IpaFrame.RSL, message.encode());
    }

    private void ccm(CcmMessage message) {
        frame(IpaFrame.CCM, CcmCodec.encode(message));
    }

    private void frame(int stream, byte[] payload) {
        onTheWay.add(new IpaFrame(stream, payload));
    }

    /** What the network answers arrives when the modem has done what it was doing. */
    private void deliver() {
        for (IpaFrame frame = onTheWay.poll(); frame != null; frame = onTheWay.poll()) {
            modem.station().frameArrived(frame, now);
        }
    }

    @Override
    public void send(IpaFrame frame) {
        try {
            if (frame.stream() == IpaFrame.SPEECH) {
                ear.accept(codec.decode(RtpPacket.decode(frame.payload()).payload()));
            } else if (frame.stream() == IpaFrame.RSL) {
                arrived(RslMessage.decode(frame.payload()));
            }
        } catch (ProtocolViolation e) {
            fail(e);
        }
    }

    private void arrived(RslMessage message) throws ProtocolViolation {
        OctetString layer3 = null;
        if (message instanceof RslMessage.EstablishIndication first) {
            layer3 = first.layer3();
        } else if (message instanceof RslMessage.DataIndication data) {
            layer3 = data.layer3();
        }
        if (layer3 != null) {
            answer(Layer3Codec.decode(layer3.toArray(), Direction.UPLINK));
        }
    }

    private void answer(Layer3Message message) {
        sent.add(message);
        if (message instanceof LocationUpdatingRequest) {
            down(new LocationUpdatingAccept(LocationArea.TEST, Optional.empty()));
            down(new ChannelRelease(0));
        } else if (message instanceof PagingResponse) {
            down(new Setup(TRANSACTION, Optional.of(CALLER), Optional.empty()));
        } else if (message instanceof CmServiceRequest) {
            down(refusal.<Layer3Message>map(CmServiceReject::new).orElseGet(CmServiceAccept::new));
        } else if (message instanceof CpData data) {
            down(new CpAck(data.transaction().answered()));
            down(new CpData(
                    data.transaction().answered(), new RpAck(data.relay().reference(), Optional.empty())));
        } else if (message instanceof CallControl callControl) {
            answer(callControl);
        }
    }

    private void answer(CallControl message) {
        if (message instanceof Connect) {
            up = true;
            down(new ConnectAcknowledge(TRANSACTION));
        } else if (message instanceof Disconnect) {
            up = false;
            down(new Release(TRANSACTION, Optional.empty()));
        } else if (message instanceof Release) {
            up = false;
            down(new ReleaseComplete(TRANSACTION, Optional.empty()));
            down(new ChannelRelease(0));
        } else if (message instanceof ReleaseComplete) {
            down(new ChannelRelease(0));
        }
    }

    @Override
    public void drop() {
        fail("the modem drops the link");
    }

    private CallDecision decide(Optional<Msisdn> from) {
        told.add("call " + from.orElseThrow());
        return decision;
    }

    private void accept(StationEvent event) {
        if (event instanceof StationEvent.Ringing ringing) {
            told.add("ringing " + ringing.from().orElseThrow());
        } else if (event instanceof StationEvent.Connected connected) {
            told.add("connected " + connected.peer().orElseThrow());
        } else if (event instanceof StationEvent.Released released) {
            told.add("ended " + released.cause().code());
        } else if (event instanceof StationEvent.MessageSent sent) {
            told.add("sms sent " + sent.id());
        } else if (event instanceof StationEvent.MessageFailed failed) {
            told.add("sms failed " + failed.id() + " " + failed.cause().code());
        } else if (event instanceof ModemEvent.CallIdle idle) {
            told.add("idle " + idle.seconds());
        } else if (event instanceof ModemEvent.KeyDecided decided) {
            told.add("key " + decided.digit().key().symbol());
        } else if (event instanceof ModemEvent.SpeechProcessed speech) {
            speechTimeSamples += speech.samples();
        } else if (event instanceof ModemEvent.ReplyToneSent sent) {
            told.add("tone " + sent.key().symbol());
        }
    }
}
