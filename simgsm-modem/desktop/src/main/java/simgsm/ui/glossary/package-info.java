/** The glossary: terms with explanations, and texts that link to them. Read {@link simgsm.ui.glossary.GlossaryText} first. */
package simgsm.ui.glossary;
