package simgsm.modem.tools;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.Options;
import simgsm.console.UsageException;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.NotAudioException;
import simgsm.speech.SpeechFile;

/** {@code decode FILE...}: keys out of sound, a line per file. */
final class DecodeTool implements Tool {
    private static final int BLOCK_SAMPLES = 4096;

    @Override
    public String word() {
        return "decode";
    }

    @Override
    public Options options() {
        return new Options(
                        "java -jar simgsm-modem.jar decode FILE.wav...",
                        "Prints path, TAB, the keys heard, TAB, when each was decided (milliseconds from the file's start).\n"
                                + "Reads any rate, channels (mixed) and sample format of WAV, AU and AIFF files.\n"
                                + "Ends with 1 if a file is no audio, with 74 if one cannot be read.")
                .arguments(Integer.MAX_VALUE);
    }

    @Override
    public int run(Arguments arguments, PrintStream out, PrintStream err) throws UsageException {
        if (arguments.rest().isEmpty()) {
            throw new UsageException("missing FILE.wav");
        }
        int status = ExitStatus.OK;
        for (String name : arguments.rest()) {
            Heard heard = new Heard();
            try {
                decode(Path.of(name), heard);
            } catch (NotAudioException e) {
                err.println("simgsm-modem: " + e.getMessage());
                status = Math.max(status, ExitStatus.FAILED);
            } catch (IOException | InvalidPathException e) {
                err.println("simgsm-modem: " + name + ": " + reason(e));
                status = ExitStatus.INPUT_OUTPUT;
            }
            out.print(name + "\t" + heard.keys + "\t" + heard.millis + "\n");
            out.flush();
        }
        return status;
    }

    private static String reason(Exception e) {
        if (e instanceof NoSuchFileException) {
            return "no such file";
        }
        return e instanceof AccessDeniedException ? "access denied" : e.getMessage();
    }

    private static void decode(Path path, Heard heard) throws IOException {
        try (SpeechFile file = SpeechFile.open(path)) {
            heard.lookAheadMillis = file.lookAheadMillis();
            DtmfReceiver receiver = new DtmfReceiver(heard);
            short[] block = new short[BLOCK_SAMPLES];
            for (int n; (n = file.read(block)) >= 0; ) {
                receiver.accept(block, 0, n);
            }
            receiver.finish();
        }
    }

    private static final class Heard implements DtmfListener {
        final StringBuilder keys = new StringBuilder();
        final StringBuilder millis = new StringBuilder();
        double lookAheadMillis;

        @Override
        public void keyDecided(DtmfDigit digit) {
            long at = Math.round(digit.decidedAtSample() / 8.0 + lookAheadMillis);
            keys.append(digit.key().symbol());
            millis.append(millis.length() == 0 ? "" : ",").append(at);
        }
    }
}
