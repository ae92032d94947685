package simgsm.gateway.sip;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.gateway.speech.SpeechBuffer;
import simgsm.speech.G711;
import simgsm.speech.SpeechCodec;
import simgsm.station.call.SpeechSource;

/**
 * The speech of a call with a SIP phone: symmetric RTP (RFC 4961) on one side, frames of the station on the other. Keys
 * by telephone-event or INFO become tones in the frames; meanwhile the phone's own sound is dropped, so that a phone
 * that sends its keys also as sound is not heard twice.
 */
final class SipSpeech implements SpeechSource {
    /** Longest gap of sequence numbers that is filled; a larger one is a new stream. */
    private static final int MOST_LOST = 10;
    /** A packet that is later than this begins a new stream. */
    private static final int MOST_LATE = 50;
    /** A key by event and the same one by INFO within this time are one. */
    private static final long SAME_KEY_NANOS = TimeUnit.SECONDS.toNanos(1);

    private static final int HALF_RANGE = 0x8000;

    private record Press(DtmfKey key, boolean isByInfo, long nanos) {}

    private final LongSupplier clock;
    private final DtmfGenerator tones = new DtmfGenerator();
    private final SpeechBuffer sound = new SpeechBuffer();
    private final PhoneEvents events = new PhoneEvents(key -> press(key, false), tones::release);
    /** Presses whose copy by the other way has not arrived. */
    private final Deque<Press> unmatched = new ArrayDeque<>();

    private final int source;
    private final List<Short> samples = new ArrayList<>();
    private SipTransport.Media media;
    private Sdp session;
    /** Source of the signalling; speech is accepted from its address and from that of the description. */
    private String phoneHost = "";
    /** Null until the first packet. */
    private SipPeer heardFrom;

    private boolean isHeard;
    private boolean isActive;
    private int heardSource;
    private int expected;
    private byte[] last = {};
    private int sequence;
    private int timestamp;
    private long heardNanos;

    SipSpeech(RandomGenerator random, LongSupplier clock) {
        source = random.nextInt();
        sequence = random.nextInt(HALF_RANGE);
        timestamp = random.nextInt();
        this.clock = clock;
    }

    void use(SipTransport.Media socket) {
        media = socket;
    }

    int port() {
        return media.port();
    }

    /** Takes a description of the phone; a new one begins the search for the source of its speech. */
    void describe(Sdp description, String host) {
        session = description;
        phoneHost = host;
        heardFrom = null;
        isHeard = false;
        heardNanos = clock.getAsLong();
    }

    /** Sends and takes speech from now on. */
    void start() {
        isActive = true;
        heardNanos = clock.getAsLong();
    }

    void close() {
        isActive = false;
        session = null;
        events.release();
        tones.drop();
        sound.clear();
        unmatched.clear();
        if (media != null) {
            media.close();
            media = null;
        }
    }

    /** Time of the newest packet of the phone. */
    long heardNanos() {
        return heardNanos;
    }

    /** A datagram on the socket. */
    void arrived(byte[] octets, SipPeer from) {
        if (!isActive || session == null) {
            return;
        }
        RtpHeader.parse(octets).filter(header -> isFromPhone(from)).ifPresent(header -> {
            heardNanos = clock.getAsLong();
            int type = header.payloadType();
            if (type == session.codec().payloadType()) {
                speech(header, header.payload(octets));
            } else if (session.eventType().isPresent()
                            && type == session.eventType().getAsInt()
                    || type == Sdp.OFFERED_EVENTS) {
                shareNumbers(header);
                events.arrived(header, header.payload(octets));
            }
        });
    }

    private boolean isFromPhone(SipPeer from) {
        if (heardFrom == null
                && (from.host().equals(session.remote().host()) || from.host().equals(phoneHost))) {
            heardFrom = from;
        }
        return from.equals(heardFrom);
    }

    private void speech(RtpHeader header, byte[] payload) {
        int ahead = isHeard && header.source() == heardSource ? (short) (header.sequence() - expected) : 0;
        if (ahead < 0 && ahead >= -MOST_LATE) {
            return; // late, or a copy
        }
        isHeard = true;
        heardSource = header.source();
        expected = header.sequence() + 1;
        for (int i = 0; i < ahead && ahead <= MOST_LOST; i++) {
            buffer(last);
        }
        last = payload;
        buffer(payload);
    }

    /** Events and sound share the sequence numbers; linphonec numbers its events apart. */
    private void shareNumbers(RtpHeader event) {
        int ahead = (short) (event.sequence() - expected);
        if (ahead >= 0 && ahead <= MOST_LATE) {
            expected = event.sequence() + 1;
        }
    }

    private void buffer(byte[] payload) {
        G711 codec = session.codec() == SpeechCodec.Kind.A_LAW ? G711.A_LAW : G711.MU_LAW;
        for (byte octet : payload) {
            samples.add(codec.expand(octet));
            if (samples.size() == SpeechCodec.SAMPLES_PER_FRAME) {
                short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
                for (int i = 0; i < frame.length; i++) {
                    frame[i] = samples.get(i);
                }
                samples.clear();
                if (tones.isIdle() && !events.isSounding()) {
                    sound.accept(frame);
                }
            }
        }
    }

    /** A key by INFO. */
    void keyByInfo(DtmfKey key) {
        if (isActive && press(key, true)) {
            tones.release();
        }
    }

    private boolean press(DtmfKey key, boolean isByInfo) {
        long now = clock.getAsLong();
        unmatched.removeIf(press -> now - press.nanos > SAME_KEY_NANOS);
        for (Press press : unmatched) {
            if (press.key == key && press.isByInfo != isByInfo) {
                unmatched.remove(press);
                return false;
            }
        }
        unmatched.add(new Press(key, isByInfo, now));
        sound.clear();
        tones.press(key);
        return true;
    }

    /** The next 20 ms from the phone. */
    @Override
    public void read(short[] frame) {
        events.framePassed();
        if (tones.isIdle()) {
            sound.read(frame);
        } else {
            tones.read(frame);
        }
    }

    @Override
    public int framesDropped() {
        return sound.framesDropped();
    }

    /** The next 20 ms from the network. */
    void heard(short[] frame) {
        if (isActive && session != null && session.isReceiving()) {
            SpeechCodec codec = session.codec().open();
            SipPeer to = heardFrom == null ? session.remote() : heardFrom;
            sequence = sequence + 1 & 0xffff;
            timestamp += SpeechCodec.SAMPLES_PER_FRAME;
            media.send(
                    RtpHeader.packet(codec.kind().payloadType(), sequence, timestamp, source, codec.encode(frame)), to);
        }
    }
}
