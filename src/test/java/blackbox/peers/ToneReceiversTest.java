package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Other DTMF receivers read our tones, and our receiver reads theirs. */
@Tag("peer")
class ToneReceiversTest {
    private static final String KEYS = "0123456789*#ABCD" + "**#**20**";

    @TempDir
    Path folder;

    @Test
    void multimonNgReadsOurTones() throws Exception {
        assertEquals(
                KEYS,
                Audio.keysHeardByMultimonNg(folder, Audio.tones(folder, KEYS).toString()));
    }

    @Test
    void spanDspReadsOurTones() throws Exception {
        Path spandsp = ToneReceiver.spandsp(folder);
        Path raw = Files.write(folder.resolve("tones.raw"), Audio.samples(Audio.tones(folder, KEYS)));
        ProcessBuilder receiver = new ProcessBuilder(spandsp.toString(), "rx", raw.toString());
        assertEquals(KEYS, Peer.run(receiver).expectSuccess().strip());
    }

    @Test
    void ourReceiverReadsSpanDspsTones() throws Exception {
        Path raw = folder.resolve("spandsp.raw");
        ProcessBuilder sender = new ProcessBuilder(ToneReceiver.spandsp(folder).toString(), "tx", KEYS, raw.toString());
        Peer.run(sender).expectSuccess();
        Path wav = Audio.wav(folder.resolve("spandsp.wav"), Files.readAllBytes(raw));
        assertEquals(KEYS, Audio.tool("decode", wav.toString()).split("\t")[1]);
    }
}
