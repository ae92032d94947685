package simgsm.tools;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.UsageException;
import simgsm.file.FileErrors;
import simgsm.octets.Octets;
import simgsm.speech.SpeechCodec;
import simgsm.speech.WavWriter;
import simgsm.tools.audio.NotAudioException;
import simgsm.tools.audio.SpeechFile;

/** {@code gsm encode IN.wav OUT.gsm} and {@code gsm decode IN.gsm OUT.wav}: GSM 06.10, 33 octets a frame. */
final class GsmTool {
    private static final SpeechCodec.Kind CODEC = SpeechCodec.Kind.GSM_FULL_RATE;

    private GsmTool() {}

    static int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception {
        if (arguments.rest().isEmpty()) {
            throw new UsageException("missing encode or decode");
        }
        String direction = arguments.rest().get(0);
        if (!direction.equals("encode") && !direction.equals("decode")) {
            throw new UsageException("expected encode or decode, found " + direction);
        }
        if (arguments.rest().size() < 3) {
            throw new UsageException("gsm " + direction + " needs an input and an output file");
        }
        Path from = Path.of(arguments.rest().get(1));
        Path to = Path.of(arguments.rest().get(2));
        if (Files.exists(to) && Files.isSameFile(from, to)) {
            throw new UsageException("expected another file for the output, found the input's " + to);
        }
        return direction.equals("encode") ? encode(from, to, err) : decode(from, to, err);
    }

    private static int encode(Path from, Path to, PrintStream err) throws IOException {
        try (SpeechFile file = SpeechFile.open(from)) {
            FileErrors.naming(to, () -> encode(file, to));
            return ExitStatus.OK;
        } catch (NotAudioException e) {
            err.println("simgsm-modem: " + e.getMessage());
            return ExitStatus.FAILED;
        }
    }

    private static void encode(SpeechFile file, Path to) throws IOException {
        SpeechCodec codec = CODEC.open();
        try (OutputStream octets = new BufferedOutputStream(Files.newOutputStream(to))) {
            short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
            for (int n; (n = file.read(frame)) > 0; ) {
                Arrays.fill(frame, n, frame.length, (short) 0);
                octets.write(codec.encode(frame));
            }
        }
    }

    private static int decode(Path from, Path to, PrintStream err) throws IOException {
        byte[] octets = FileErrors.naming(from, () -> Files.readAllBytes(from));
        return FileErrors.naming(to, () -> decode(octets, from, to, err));
    }

    private static int decode(byte[] octets, Path from, Path to, PrintStream err) throws IOException {
        int length = CODEC.octetsPerFrame();
        SpeechCodec codec = CODEC.open();
        int status = ExitStatus.OK;
        try (WavWriter wav = new WavWriter(to, 1)) {
            for (int at = 0; at < octets.length; at += length) {
                if (octets.length - at < length) {
                    err.println("simgsm-modem: " + from + ": the last frame is incomplete");
                    status = ExitStatus.FAILED;
                    break;
                }
                try {
                    wav.write(codec.decode(Octets.range(octets, at, at + length)));
                } catch (IllegalArgumentException e) {
                    err.println("simgsm-modem: " + from + ": octet " + at + ": " + e.getMessage());
                    return ExitStatus.FAILED;
                }
            }
        }
        return status;
    }
}
