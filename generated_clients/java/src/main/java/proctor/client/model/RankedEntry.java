/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.Map;
import java.util.Set;
import proctor.client.JSON;

public class RankedEntry {
  @SerializedName("entry")
  @javax.annotation.Nonnull
  private BoardEntry entry;

  @SerializedName("rank")
  private RankInterval rank;

  @SerializedName("better")
  @javax.annotation.Nonnull
  private Integer better;

  @SerializedName("worse")
  @javax.annotation.Nonnull
  private Integer worse;

  @SerializedName("letters")
  @javax.annotation.Nonnull
  private List<String> letters;

  public BoardEntry getEntry() {
    return entry;
  }

  public RankedEntry entry(BoardEntry entry) {
    this.entry = entry;
    return this;
  }

  public void setEntry(BoardEntry entry) {
    this.entry = entry;
  }

  public RankInterval getRank() {
    return rank;
  }

  public RankedEntry rank(RankInterval rank) {
    this.rank = rank;
    return this;
  }

  public void setRank(RankInterval rank) {
    this.rank = rank;
  }

  /** How many entries are significantly better; 0 without a rank. */
  public Integer getBetter() {
    return better;
  }

  public RankedEntry better(Integer better) {
    this.better = better;
    return this;
  }

  public void setBetter(Integer better) {
    this.better = better;
  }

  /** How many entries are significantly worse; 0 without a rank. */
  public Integer getWorse() {
    return worse;
  }

  public RankedEntry worse(Integer worse) {
    this.worse = worse;
    return this;
  }

  public void setWorse(Integer worse) {
    this.worse = worse;
  }

  /** Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank. */
  public List<String> getLetters() {
    return letters;
  }

  public RankedEntry letters(List<String> letters) {
    this.letters = letters;
    return this;
  }

  public void setLetters(List<String> letters) {
    this.letters = letters;
  }

  public static RankedEntry fromJson(String text) {
    return JSON.getGson().fromJson(text, RankedEntry.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
