package blackbox.peers;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** What a telephone line, a recorder or a codec does to sound; each made by a program from elsewhere. */
enum Treatment {
    AS_IS,
    A_LAW("-t al"),
    GSM("-t gsm"),
    GSM_TWICE("-t gsm", "-t gsm"),
    G726_32(32000),
    G726_16(16000),
    MP3("mp3"),
    OPUS("opus"),
    LOUDER_CLIPPED("gain 12"),
    SOFTER("gain -12"),
    SPEED_080("speed 0.8"),
    SPEED_087("speed 0.87"),
    SPEED_093("speed 0.93"),
    SPEED_107("speed 1.07"),
    SPEED_115("speed 1.15"),
    SPEED_125("speed 1.25"),
    NOISE("noise");

    /** White noise of the treatment NOISE. */
    private static final double NOISE_DBM0 = -35;

    private final List<String> steps;
    private final int g726Rate;

    Treatment(String... steps) {
        this.steps = List.of(steps);
        g726Rate = 0;
    }

    Treatment(int g726Rate) {
        steps = List.of("g726");
        this.g726Rate = g726Rate;
    }

    /** The treated sound in a new file. */
    Path of(Path raw, Path spandsp) throws Exception {
        Path last = raw;
        for (String step : steps) {
            Path next = Path.of(last + "." + name());
            apply(step, last.toString(), next.toString(), spandsp);
            last = next;
        }
        return last;
    }

    private void apply(String step, String in, String out, Path spandsp) throws Exception {
        String coded = out + ".coded";
        switch (step) {
            case "g726" ->
                Peer.run(new ProcessBuilder(spandsp.toString(), "g726", String.valueOf(g726Rate), in, out))
                        .expectSuccess();
            case "mp3" -> {
                Peer.LAME
                        .run("--quiet", "-r", "-s", "8", "-m", "m", "--resample", "8", "-b", "16", in, coded)
                        .expectSuccess();
                Peer.LAME.run("--quiet", "--decode", "-t", coded, out).expectSuccess();
            }
            case "opus" -> {
                Peer.OPUSENC
                        .run(words("--quiet --raw --raw-rate 8000 --raw-chan 1 --bitrate 8", in, coded))
                        .expectSuccess();
                Peer.OPUSDEC
                        .run(words("--quiet --rate 8000", coded, out + ".wav"))
                        .expectSuccess();
                sox(out + ".wav", Sound.RAW, out);
            }
            case "noise" -> addNoise(in, out);
            default -> {
                if (step.startsWith("-t")) {
                    sox(Sound.RAW + " " + in, step + " -r 8000 -c 1", coded);
                    sox(step + " -r 8000 -c 1 " + coded, Sound.RAW, out);
                } else {
                    Peer.SOX
                            .run(words(Sound.RAW + " " + in + " " + Sound.RAW, out + " " + step))
                            .expectSuccess();
                }
            }
        }
        Files.deleteIfExists(Path.of(coded));
    }

    private static void sox(String in, String options, String out) throws Exception {
        Peer.SOX.run(words(in + " " + options, out)).expectSuccess();
    }

    private static String[] words(String... parts) {
        List<String> all = new ArrayList<>();
        for (String part : parts) {
            all.addAll(List.of(part.split(" ")));
        }
        return all.toArray(String[]::new);
    }

    private static void addNoise(String in, String out) throws Exception {
        Sound noisy = new Sound(1);
        short[] samples = Sound.read(Path.of(in));
        noisy.silence(samples.length / 8);
        noisy.add(samples);
        noisy.addNoise(NOISE_DBM0, 0, noisy.length());
        noisy.write(Path.of(out));
    }
}
