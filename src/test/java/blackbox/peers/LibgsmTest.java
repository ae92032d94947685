package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The full-rate codec agrees with libgsm's {@code toast} and {@code untoast}, octet for octet. */
@Tag("peer")
class LibgsmTest {
    private static final int FRAMES = 500;

    @TempDir
    Path folder;

    @Test
    void tonesAreEncodedAlike() throws Exception {
        requireSameEncoding(Audio.samples(Audio.tones(folder, "0123456789*#ABCD")));
    }

    @Test
    void noiseOfAllLevelsIsEncodedAlike() throws Exception {
        byte[] samples = new byte[FRAMES * 320];
        Random random = new Random(1);
        for (int i = 0; i < samples.length; i += 2) {
            double level = Math.pow(10, i * 4.5 / samples.length);
            int sample = (int) Math.max(-32768, Math.min(32767, level * random.nextGaussian()));
            samples[i] = (byte) sample;
            samples[i + 1] = (byte) (sample >> 8);
        }
        requireSameEncoding(samples);
    }

    private void requireSameEncoding(byte[] samples) throws Exception {
        byte[] whole = java.util.Arrays.copyOf(samples, samples.length / 320 * 320);
        Path ours = folder.resolve("ours.gsm");
        Audio.tool("gsm", "encode", Audio.wav(folder.resolve("in.wav"), whole).toString(), ours.toString());
        assertArrayEquals(convert(Peer.TOAST, whole), Files.readAllBytes(ours));
    }

    @Test
    void anyFramesAreDecodedAlike() throws Exception {
        byte[] frames = new byte[FRAMES * 33];
        new Random(5).nextBytes(frames);
        for (int i = 0; i < frames.length; i += 33) {
            frames[i] = (byte) (0xD0 | frames[i] & 15);
        }
        Path ours = folder.resolve("ours.wav");
        Path in = Files.write(folder.resolve("random.gsm"), frames);
        Audio.tool("gsm", "decode", in.toString(), ours.toString());
        assertArrayEquals(convert(Peer.UNTOAST, frames), Audio.samples(ours));
    }

    @Test
    void keysAreFoundInTheGsmFilesThatSoxWrites() throws Exception {
        Path tones = Audio.tones(folder, "0123456789*#ABCD");
        for (String name : new String[] {"plain.gsm", "tag49.wav"}) {
            Path file = folder.resolve(name);
            Peer.SOX
                    .run(tones.toString(), "-e", "gsm-full-rate", file.toString())
                    .expectSuccess();
            assertEquals(
                    "0123456789*#ABCD", Audio.tool("decode", file.toString()).split("\t")[1]);
        }
    }

    private byte[] convert(Peer peer, byte[] input) throws Exception {
        Path in = Files.write(folder.resolve("peer.in"), input);
        Path out = folder.resolve("peer.out");
        Process process = peer.process("-l", "-c")
                .redirectErrorStream(false)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .redirectInput(in.toFile())
                .redirectOutput(out.toFile())
                .start();
        process.waitFor();
        return Files.readAllBytes(out);
    }
}
