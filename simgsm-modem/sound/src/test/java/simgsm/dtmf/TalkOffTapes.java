package simgsm.dtmf;

import static simgsm.dtmf.Catalogue.silent;
import static simgsm.dtmf.Catalogue.through;
import static simgsm.dtmf.Catalogue.voice;

import simgsm.speech.SpeechCodec;

/** What is heard on telephone lines beside keys. */
final class TalkOffTapes {
    private TalkOffTapes() {}

    private static final double[][] NETWORK_TONES = {
        {350, 440},
        {440, 480},
        {480, 620},
        {425},
        {400},
        {450},
        {400, 450},
        {1400},
        {1100},
        {2100},
        {440},
        {950},
        {1400, 1800},
        {950, 1400},
        {2130, 2750},
        {1300},
        {914, 1429},
        {985, 1371},
        {2600},
        {330, 440},
        {1000},
        {700, 900},
        {1100, 1700},
        {540, 660}
    };

    static void add() {
        silent("network tones", tape -> {
            double[] hertz = NETWORK_TONES[tape.random.nextInt(NETWORK_TONES.length)];
            tape.silence(8000);
            int[] cadence = {30 + tape.random.nextInt(600), 30 + tape.random.nextInt(600)};
            tape.add(Voices.atLevel(Voices.cadence(tape.random, tape.length(), hertz, cadence), tape.uniform(-25, -5)));
        });
        silent("speech", tape -> {
            tape.silence(20000);
            voice(tape, tape.uniform(-30, -10));
        });
        silent("music", tape -> {
            tape.silence(20000);
            tape.add(Voices.atLevel(Voices.music(tape.random, tape.length()), tape.uniform(-30, -10)));
        });
        silent("sirens", tape -> {
            tape.silence(10000);
            tape.add(Voices.atLevel(Voices.siren(tape.random, tape.length()), tape.uniform(-30, -8)));
        });
        silent("noise", tape -> {
            tape.silence(10000);
            tape.noise(tape.uniform(-40, -5));
        });
        silent("coloured noise", tape -> {
            tape.silence(10000);
            tape.add(Voices.atLevel(Voices.colouredNoise(tape.random, tape.length()), tape.uniform(-30, -8)));
        });
        silent("speech through GSM", tape -> {
            tape.silence(10000);
            voice(tape, tape.uniform(-30, -10));
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        silent("speech in noise", tape -> {
            tape.silence(10000);
            double level = tape.uniform(-30, -12);
            voice(tape, level);
            tape.noise(level - tape.uniform(3, 25));
        });
        silent("more network tones", tape -> {
            double[] hertz = MORE_NETWORK_TONES[tape.random.nextInt(MORE_NETWORK_TONES.length)];
            tape.silence(8000);
            int[] cadence = CADENCES[tape.random.nextInt(CADENCES.length)];
            tape.add(Voices.atLevel(Voices.cadence(tape.random, tape.length(), hertz, cadence), tape.uniform(-25, -5)));
        });
        silent("special information tones", tape -> {
            for (int k = 0; k < 6; k++) {
                for (double hertz : new double[] {950, 1400, 1800}) {
                    int at = tape.length();
                    tape.silence(330);
                    double[] beep = Voices.atLevel(Voices.cadence(tape.random, 2640, new double[] {hertz}, 330), -13);
                    System.arraycopy(beep, 0, tape.sound, at, beep.length);
                }
                tape.silence(tape.uniform(0, 1000));
            }
        });
        for (double[] kind : new double[][] {
            {1180, 980, 300},
            {1850, 1650, 300},
            {1300, 2100, 1200},
            {1200, 2200, 1200},
            {1270, 1070, 300},
            {2225, 2025, 300},
            {390, 450, 75}
        }) {
            silent("modem " + (int) kind[0] + "/" + (int) kind[1], tape -> {
                tape.silence(6000);
                tape.add(Voices.atLevel(
                        Talkers.modem(tape.random, tape.length(), kind[0], kind[1], kind[2]), tape.uniform(-25, -5)));
            });
        }
        silent("register signals R1", tape -> {
            tape.silence(8000);
            tape.add(Voices.atLevel(
                    Talkers.pairs(tape.random, tape.length(), new double[] {900, 1100, 1300, 1500, 1700}, 68, 68),
                    -10));
        });
        silent("register signals R2", tape -> {
            tape.silence(8000);
            double[] tones = tape.random.nextBoolean()
                    ? new double[] {1380, 1500, 1620, 1740, 1860, 1980}
                    : new double[] {1140, 1020, 900, 780, 660, 540};
            tape.add(Voices.atLevel(Talkers.pairs(tape.random, tape.length(), tones, 100, 50), -10));
        });
        silent("another voice", tape -> {
            tape.silence(20000);
            tape.add(Voices.atLevel(Talkers.talk(tape.random, tape.length()), tape.uniform(-30, -10)));
        });
        silent("another voice through A-law and GSM", tape -> {
            tape.silence(10000);
            tape.add(Voices.atLevel(Talkers.talk(tape.random, tape.length()), tape.uniform(-25, -10)));
            through(tape, SpeechCodec.Kind.A_LAW);
            through(tape, SpeechCodec.Kind.GSM_FULL_RATE);
        });
        silent("harmonics", tape -> {
            tape.silence(20000);
            tape.add(Voices.atLevel(Talkers.harmonics(tape.random, tape.length()), tape.uniform(-30, -10)));
        });
        silent("babble", tape -> {
            tape.silence(10000);
            double[] babble = new double[tape.length()];
            for (int k = 2 + tape.random.nextInt(6); k > 0; k--) {
                double[] one = tape.random.nextBoolean()
                        ? Talkers.talk(tape.random, babble.length)
                        : Voices.speech(tape.random, babble.length);
                for (int i = 0; i < babble.length; i++) {
                    babble[i] += one[i];
                }
            }
            tape.add(Voices.atLevel(babble, tape.uniform(-25, -8)));
        });
        silent("whistling", tape -> {
            tape.silence(10000);
            tape.add(Voices.atLevel(Talkers.whistle(tape.random, tape.length()), tape.uniform(-25, -8)));
        });
        silent("knocks", tape -> {
            tape.silence(10000);
            tape.add(Voices.atLevel(Talkers.knocks(tape.random, tape.length()), tape.uniform(-25, -8)));
        });
        silent("chirps", tape -> {
            tape.silence(10000);
            tape.add(Voices.atLevel(Talkers.chirps(tape.random, tape.length()), tape.uniform(-25, -8)));
        });
        silent("clipped speech", tape -> {
            tape.silence(10000);
            voice(tape, -8);
            tape.clip(tape.uniform(3000, 12000));
        });
        silent("speech in a telephone's band", tape -> {
            tape.silence(10000);
            tape.add(Voices.atLevel(Talkers.talk(tape.random, tape.length()), -10))
                    .telephoneBand();
        });
    }

    private static final double[][] MORE_NETWORK_TONES = {
        {350, 450},
        {440, 400},
        {375, 475},
        {425, 400},
        {450, 500},
        {400, 425, 450},
        {480},
        {620},
        {350},
        {600, 120},
        {600, 133},
        {420, 40},
        {425, 25},
        {400, 17},
        {1020, 1140},
        {2100, 15},
        {440, 620},
        {1000, 1400},
        {697, 1100},
        {852, 1000},
        {1800},
        {2400},
        {2600, 2400},
        {900, 1700}
    };

    private static final int[][] CADENCES = {
        {400, 200, 400, 2000},
        {1000, 4000},
        {2000, 4000},
        {500, 500},
        {250, 250},
        {200, 200},
        {100, 100},
        {1500, 3500},
        {330, 1000},
        {50, 50},
        {75, 75, 75, 275},
        {8000}
    };
}
