package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import blackbox.FinishedProgram;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Sound as WAV for our tools and as raw samples (8 kHz, 16 bit, little-endian, mono) for the peers. */
final class Audio {
    private static final int HEADER = 44;

    private Audio() {}

    /** Runs a command of simgsm-modem.jar, which must succeed, and returns its standard output. */
    static String tool(String... arguments) throws Exception {
        FinishedProgram tool = FinishedProgram.run("simgsm-modem", arguments);
        assertEquals(0, tool.status(), tool.error());
        return tool.output();
    }

    /** Writes samples as a WAV file. */
    static Path wav(Path file, byte[] samples) throws Exception {
        ByteBuffer wav = ByteBuffer.allocate(HEADER + samples.length).order(ByteOrder.LITTLE_ENDIAN);
        wav.put("RIFF".getBytes()).putInt(HEADER - 8 + samples.length).put("WAVEfmt ".getBytes());
        wav.putInt(16).putShort((short) 1).putShort((short) 1).putInt(8000).putInt(16000);
        wav.putShort((short) 2).putShort((short) 16).put("data".getBytes()).putInt(samples.length);
        return Files.write(file, wav.put(samples).array());
    }

    /** The samples of a WAV file as our tools write it, with a header of 44 octets. */
    static byte[] samples(Path wav) throws Exception {
        byte[] octets = Files.readAllBytes(wav);
        return Arrays.copyOfRange(octets, HEADER, octets.length);
    }

    /** The keys that multimon-ng hears in a file, which sox reads with these arguments. */
    static String keysHeardByMultimonNg(Path folder, String... file) throws Exception {
        Path raw = folder.resolve("multimon.raw");
        List<String> conversion = new ArrayList<>(List.of(file));
        conversion.addAll(List.of("-t", "raw", "-e", "signed-integer", "-b", "16", "-r", "22050", raw.toString()));
        Peer.SOX.run(conversion.toArray(String[]::new)).expectSuccess();
        return Peer.MULTIMON_NG
                .run("-q", "-a", "DTMF", "-t", "raw", raw.toString())
                .text()
                .lines()
                .filter(line -> line.startsWith("DTMF: "))
                .map(line -> line.substring("DTMF: ".length()).strip())
                .collect(Collectors.joining());
    }

    /** The samples of keys as the tool {@code tones} makes them. */
    static Path tones(Path folder, String keys) throws Exception {
        Path file = folder.resolve("tones.wav");
        tool("tones", keys, file.toString());
        return file;
    }
}
