package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfReceiver;
import simgsm.modem.CallWords;
import simgsm.modem.ModemEvent;
import simgsm.modem.VoiceStore;
import simgsm.speech.Resampler;
import simgsm.speech.SpeechCodec;
import simgsm.words.FrontEnd;
import simgsm.words.Prompts;
import simgsm.words.SpeakerTemplates;
import simgsm.words.SpeechFrame;
import simgsm.words.SpokenLanguage;
import simgsm.words.SpokenWord;
import simgsm.words.WordCutter;

/**
 * Orders by voice with words of people and of other programs' voices: digits of the Free Spoken Digit Dataset
 * (github.com/Jakobovski/free-spoken-digit-dataset, in the folder of {@code -Dfsdd=DIR/recordings}), command words of flite and
 * espeak-ng. Each caller enrols four takes of each word; other takes are heard.
 */
@Tag("peer")
class SpokenOrdersTest {
    private static final List<String> PEOPLE = List.of("george", "jackson", "lucas", "nicolas", "theo", "yweweler");
    private static final List<String> DIGITS =
            List.of("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine");
    private static final List<String> COMMANDS = List.of("forward", "turn", "right", "stop", "status", "yes", "no");
    private static final List<String> VOICES = List.of("slt", "rms", "awb", "kal", "espeak");
    /** Words a minute, or parts of a hundred of the duration; the first four are enrolled. */
    private static final int[] PACES = {100, 108, 93, 104, 97, 102, 106};

    /** Effective value of a word's loud parts, and of the room's noise 30 dB below it, which does not end with the word. */
    private static final double LEVEL = 1600;

    private static final double ROOM = LEVEL * Math.pow(10, -30.0 / 20);

    private static final int ENROLLED = 4;
    private static final int TAKES = 50;
    private static final int ORDERS = 200;
    private static final int FRAME = SpeechCodec.SAMPLES_PER_FRAME;

    @TempDir
    Path folder;

    private final Random random = new Random(1);
    private final Map<String, short[]> made = new HashMap<>();
    private Path recordings;

    @BeforeEach
    void material() {
        String given = System.getProperty("fsdd", "");
        Peer.require(!given.isEmpty() && Files.isDirectory(Path.of(given)), "-Dfsdd=DIR with recordings of digits");
        recordings = Path.of(given);
        for (Peer peer : List.of(Peer.FLITE, Peer.ESPEAK_NG, Peer.SOX)) {
            peer.require();
        }
    }

    private short[] digit(String person, int digit, int take) throws Exception {
        return samples(recordings.resolve(digit + "_" + person + "_" + take + ".wav"));
    }

    private static short[] samples(Path wav) throws Exception {
        byte[] octets = Audio.samples(wav);
        short[] samples = new short[octets.length / 2];
        ByteBuffer.wrap(octets).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(samples);
        return samples;
    }

    private short[] command(String voice, String word, int pace) throws Exception {
        String key = voice + word + pace;
        if (!made.containsKey(key)) {
            Path wide = folder.resolve("wide.wav");
            Path narrow = folder.resolve("narrow.wav");
            String stretch = "duration_stretch=" + pace / 100.0;
            (voice.equals("espeak")
                            ? Peer.ESPEAK_NG.run("-v", "en-us", "-s", "" + 15000 / pace, "-w", "" + wide, word)
                            : Peer.FLITE.run("-voice", voice, "--setf", stretch, "-t", word, "-o", "" + wide))
                    .expectSuccess();
            Peer.SOX
                    .run("" + wide, "-r", "8000", "-c", "1", "-b", "16", "" + narrow)
                    .expectSuccess();
            made.put(key, samples(narrow));
        }
        return made.get(key);
    }

    /** With 0.2 s around it, level within 6 dB, white noise below the usual level, and a codec. */
    private short[] overTelephone(short[] word, double snrDecibels, SpeechCodec.Kind kind) {
        double[] powers = IntStream.range(0, word.length)
                .mapToDouble(i -> (double) word[i] * word[i])
                .toArray();
        double limit = Arrays.stream(powers).max().orElseThrow() / 1000;
        double power =
                Arrays.stream(powers).filter(each -> each > limit).average().orElseThrow();
        double gain = LEVEL * Math.pow(10, (random.nextDouble() * 12 - 6) / 20) / Math.sqrt(power);
        double sigma = LEVEL * Math.pow(10, -snrDecibels / 20);
        short[] sound = new short[(word.length + 3200) / FRAME * FRAME];
        for (int i = 0; i < sound.length; i++) {
            int at = i - 1600;
            double sample = at >= 0 && at < word.length ? gain * word[at] : 0;
            sound[i] = Resampler.saturate((float) (sample + sigma * random.nextGaussian()));
        }
        SpeechCodec there = kind.open();
        SpeechCodec here = kind.open();
        for (int at = 0; at < sound.length; at += FRAME) {
            short[] frame = here.decode(there.encode(Arrays.copyOfRange(sound, at, at + FRAME)));
            System.arraycopy(frame, 0, sound, at, FRAME);
        }
        return sound;
    }

    private short[] spoken(short[] word) {
        return overTelephone(word, 30, SpeechCodec.Kind.A_LAW);
    }

    /** One person's digits and one voice's commands, and the call to a robot. */
    private final class Caller implements VoiceStore {
        private final String person;
        private final String voice;
        private final SpeakerTemplates templates = new SpeakerTemplates();
        private final List<String> said = new ArrayList<>();
        private final List<String> orders = new ArrayList<>();
        private final CallWords robot =
                new CallWords(Optional.of(Prompts.of(SpokenLanguage.ENGLISH)), Optional.of(this), event -> {
                    if (event instanceof ModemEvent.WordsBegun words) {
                        said.add(words.text());
                    } else if (event instanceof ModemEvent.OrderSpoken order) {
                        orders.add(order.keys());
                    }
                });

        Caller(String person, String voice) throws Exception {
            this.person = person;
            this.voice = voice;
            for (String word : COMMANDS) {
                for (int i = 0; i < ENROLLED; i++) {
                    enrol(word, spoken(command(voice, word, PACES[i])));
                }
            }
            for (String word : DIGITS) {
                for (int i = 0; i < ENROLLED; i++) {
                    enrol(word, spoken(digit(person, DIGITS.indexOf(word), i)));
                }
            }
        }

        private void enrol(String word, short[] sound) {
            List<SpeechFrame> frames = new ArrayList<>();
            new FrontEnd(frames::add).accept(sound);
            WordCutter.cut(frames).map(SpokenWord::of).ifPresent(it -> templates.add(word, it));
        }

        @Override
        public SpeakerTemplates read(String caller) {
            return templates;
        }

        @Override
        public void add(String caller, String word, int number, SpokenWord template) {}

        /** Hears one frame of the robot and says one. @return true if the robot spoke */
        private boolean pass(short[] frame) {
            short[] heard = new short[FRAME];
            robot.read(heard, false);
            robot.hear(frame);
            return IntStream.range(0, FRAME).anyMatch(i -> heard[i] != 0);
        }

        /** Listens until the robot has been silent for so long. */
        private void listen(int silentFrames) {
            for (int silent = 0; silent < silentFrames; ) {
                short[] quiet = new short[FRAME];
                for (int i = 0; i < FRAME; i++) {
                    quiet[i] = (short) (ROOM * random.nextGaussian());
                }
                silent = pass(quiet) ? 0 : silent + 1;
            }
        }

        private void say(String word) throws Exception {
            int take = ENROLLED + random.nextInt(PACES.length - ENROLLED);
            short[] sound = DIGITS.contains(word)
                    ? spoken(digit(person, DIGITS.indexOf(word), 4 + random.nextInt(TAKES - 4)))
                    : spoken(command(voice, word, PACES[take]));
            for (int at = 0; at < sound.length; at += FRAME) {
                pass(Arrays.copyOfRange(sound, at, at + FRAME));
            }
            listen(25);
        }

        /** Says an order; repeats what is asked again; confirms only what was read back right. @return the keys executed */
        Optional<String> order(List<String> words) throws Exception {
            orders.clear();
            said.clear();
            robot.listen(Optional.of(Msisdn.parse("5550100")));
            listen(25);
            String wanted = String.join(" ", words) + " say yes";
            for (int next = 0; robot.isListening(); ) {
                int before = said.size();
                if (next < words.size()) {
                    say(words.get(next));
                } else {
                    listen(100);
                }
                String last = said.get(said.size() - 1);
                boolean isNew = said.size() > before;
                if (isNew && last.endsWith("say yes")) {
                    say(last.equalsIgnoreCase(wanted) ? "yes" : "no");
                    next = 0;
                } else {
                    next += isNew ? 0 : 1;
                }
            }
            return orders.stream().findFirst();
        }
    }

    private List<String> order() {
        List<String> words = new ArrayList<>(List.of(random.nextBoolean() ? "forward" : "turn"));
        if (words.get(0).equals("turn") && random.nextBoolean()) {
            words.add("right");
        }
        for (int digits = 1 + random.nextInt(3); digits > 0; digits--) {
            words.add(DIGITS.get(random.nextInt(10)));
        }
        return words;
    }

    private static String keys(List<String> words) {
        StringBuilder keys = new StringBuilder(words.get(0).equals("turn") ? "**#*#" : "**#**");
        words.stream().filter(DIGITS::contains).forEach(word -> keys.append(DIGITS.indexOf(word)));
        return keys.append("**").toString();
    }

    @Test
    void ofTwoHundredSpokenOrdersNoWrongOneIsExecuted() throws Exception {
        List<Caller> callers = new ArrayList<>();
        for (int i = 0; i < PEOPLE.size(); i++) {
            callers.add(new Caller(PEOPLE.get(i), VOICES.get(i % VOICES.size())));
        }
        int right = 0;
        List<String> wrong = new ArrayList<>();
        for (int i = 0; i < ORDERS; i++) {
            List<String> words = order();
            Optional<String> executed = callers.get(i % callers.size()).order(words);
            right += executed.filter(keys(words)::equals).isPresent() ? 1 : 0;
            executed.filter(keys -> !keys.equals(keys(words))).ifPresent(keys -> wrong.add(words + " " + keys));
        }
        int keys = ORDERS - right - wrong.size();
        System.out.println(
                "  spoken orders: " + right + " right, " + wrong.size() + " wrong, " + keys + " sent to the keys");
        assertEquals(List.of(), wrong);
        assertTrue(right >= ORDERS / 2, right + " of " + ORDERS);
    }

    @Test
    void inTwelveThousandUtterancesNoKeyIsHeard() throws Exception {
        List<String> keys = new ArrayList<>();
        int utterances = 0;
        for (SpeechCodec.Kind kind : SpeechCodec.Kind.values()) {
            for (double snr : new double[] {30, 15}) {
                for (String person : PEOPLE) {
                    for (int i = 0; i < 10 * TAKES; i++) {
                        String name = person + " " + i + " " + kind + " " + snr;
                        new DtmfReceiver(key -> keys.add(name + ": " + key.key().symbol()))
                                .accept(overTelephone(digit(person, i / TAKES, i % TAKES), snr, kind));
                        utterances++;
                    }
                }
            }
        }
        System.out.println("  utterances: " + utterances + ", keys heard in them: " + keys);
        assertTrue(utterances >= 10_000, utterances + " utterances");
        assertEquals(List.of(), keys);
    }
}
