package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
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
        Path raw = folder.resolve("tones.raw");
        Path wav = Audio.tones(folder, KEYS);
        Peer.SOX
                .run(wav.toString(), "-t", "raw", "-e", "signed-integer", "-b", "16", "-r", "22050", raw.toString())
                .expectSuccess();
        String heard = Peer.MULTIMON_NG
                .run("-q", "-a", "DTMF", "-t", "raw", raw.toString())
                .text();
        assertEquals(
                KEYS,
                heard.lines()
                        .filter(line -> line.startsWith("DTMF: "))
                        .map(line -> line.substring("DTMF: ".length()).strip())
                        .collect(Collectors.joining()),
                heard);
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
