package simgsm.words;

/**
 * The result of a comparison with a speaker's templates.
 *
 * @param word the nearest one
 * @param second the nearest other word; empty if there is none
 * @param ratio of their distances, 0 to 1; 0 without a second, 1 for a word of another length
 * @param hasItsLength false for a word more than 2.2 times as long or short as the nearest one
 */
public record HeardWord(String word, String second, double ratio, boolean hasItsLength) {
    /**
     * Words nearer to a second one are refused. Chosen on three of six people, so that at most 0.2 % of their digits are taken
     * for another one (docs/MEASURED.md has the others).
     */
    public static final double MOST_RATIO = 0.92;

    /** False if the word is refused: it has another length, or a second one is nearly as near. */
    public boolean isSure() {
        return hasItsLength && ratio <= MOST_RATIO;
    }
}
