package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.speech.SpeechCodec;

/** A page's side of the gateway's socket: JSON and A-law as the page sends them, in real time. */
public final class WebPhone extends JsonSocket {
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor();
    private final DtmfGenerator keys = new DtmfGenerator();
    private final SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
    private final ByteArrayOutputStream heard = new ByteArrayOutputStream();

    /** Opens the socket and sends a first message. */
    public WebPhone(String port, String first) {
        super(port, "/phone", builder -> builder.subprotocols("simgsm.v1"));
        say(first);
    }

    /** Sends sound from now on, a frame every 20 ms. */
    public void speak() {
        clock.scheduleAtFixedRate(this::sendFrame, 0, 20, TimeUnit.MILLISECONDS);
    }

    private void sendFrame() {
        short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
        synchronized (keys) {
            keys.read(frame);
        }
        sendOctets(codec.encode(frame));
    }

    public void press(String pressed) {
        synchronized (keys) {
            DtmfKey.sequence(pressed).forEach(keys::enqueue);
        }
    }

    /** Waits for an event of this name, and skips others. */
    public Map<String, Object> expect(String name) {
        return expect(event -> name.equals(event.get("event")), name);
    }

    /** Waits for an event with this value. */
    public Map<String, Object> expect(String name, String field, String value) {
        return expect(
                event -> name.equals(event.get("event")) && value.equals(event.get(field)),
                name + " " + field + "=" + value);
    }

    /** Waits for an event; none of the other name may come before it. */
    void expectBefore(String forbidden, String name) {
        Map<String, Object> event =
                expect(each -> List.of(forbidden, name).contains(each.get("event")), name + " without " + forbidden);
        assertEquals(name, event.get("event"));
    }

    /** What has been heard so far. */
    short[] heard() {
        byte[] octets;
        synchronized (heard) {
            octets = heard.toByteArray();
        }
        short[] samples = new short[octets.length];
        for (int from = 0; from < octets.length; from += SpeechCodec.SAMPLES_PER_FRAME) {
            byte[] frame = new byte[SpeechCodec.SAMPLES_PER_FRAME];
            System.arraycopy(octets, from, frame, 0, frame.length);
            System.arraycopy(codec.decode(frame), 0, samples, from, frame.length);
        }
        return samples;
    }

    @Override
    public CompletionStage<?> onBinary(WebSocket from, ByteBuffer part, boolean last) {
        byte[] octets = new byte[part.remaining()];
        part.get(octets);
        synchronized (heard) {
            heard.writeBytes(octets);
        }
        from.request(1);
        return null;
    }

    @Override
    void cut() {
        stopSpeaking();
        super.cut();
    }

    private void stopSpeaking() {
        List<Runnable> unused = clock.shutdownNow();
        unused.clear();
    }
}
