package simgsm.words;

/**
 * The result of a comparison with a speaker's templates.
 *
 * @param word the nearest one
 * @param second the nearest other word; empty if there is none
 * @param ratio of their distances, 0 to 1; 0 without a second, 1 for a word more than 2.2 times as long or short
 */
public record HeardWord(String word, String second, double ratio) {
    /**
     * Words nearer to a second one are refused. Chosen on three of six people, so that at most 0.2 % of their digits are taken
     * for another one (docs/MEASURED.md has the others).
     */
    public static final double MOST_RATIO = 0.92;

    /** False if the word is refused: a second one is nearly as near. */
    public boolean isSure() {
        return ratio <= MOST_RATIO;
    }
}
